#include "export/povray/pavement_ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/lattice.h"
#include "paving/surface/ground.h"
#include "paving/surface/stone_surface.h"

namespace shatterpave::exporting::povray {

namespace {

double rounded(double mm) { return geometry::to_mm(geometry::to_lattice(mm)); }

void append_bed_ring(std::string& text, const geometry::Polygon& ring) {
  const auto append_vertex = [&](const vec2& vertex) {
    text += '<';
    append_decimal(text, geometry::to_lattice(vertex.x), 3);
    text += ',';
    append_decimal(text, geometry::to_lattice(vertex.y), 3);
    text += '>';
  };
  text += "   ";
  for (const vec2& vertex : ring) {
    append_vertex(vertex);
    text += ", ";
  }
  append_vertex(ring.front());
}

// A prism over the area, between two heights as POV-Ray reads them, with `last` as its last line.
void append_prism(std::string& text, const paving::Pavement& pavement, const std::string& low, const std::string& high,
                  const std::string& last) {
  std::size_t points = pavement.area.outline.size() + 1;
  for (const geometry::Polygon& hole : pavement.area.holes) points += hole.size() + 1;
  text += fmt::format("prism {{\n   linear_sweep linear_spline {}, {}, {},\n", low, high, points);
  append_bed_ring(text, pavement.area.outline);
  for (const geometry::Polygon& hole : pavement.area.holes) {
    text += ",\n";
    append_bed_ring(text, hole);
  }
  text += "\n" + last + "}\n";
}

// ---- sunken ground

struct Mesh {
  std::string vertices;
  std::string normals;
  std::string faces;
  std::size_t columns = 0;
  std::size_t rows = 0;
};

Mesh sunken_surface(const paving::Pavement& pavement, std::uint64_t seed) {
  const geometry::Box box = geometry::bounding_box(pavement.area.outline);
  const vec2 size = box.high - box.low;
  const double step = paving::ground_square_mm(pavement);
  Mesh mesh;
  mesh.columns = static_cast<std::size_t>(std::ceil(size.x / step));
  mesh.rows = static_cast<std::size_t>(std::ceil(size.y / step));
  for (std::size_t row = 0; row <= mesh.rows; ++row) {
    for (std::size_t column = 0; column <= mesh.columns; ++column) {
      const vec2 place = box.low + size * vec2{static_cast<double>(column) / static_cast<double>(mesh.columns),
                                               static_cast<double>(row) / static_cast<double>(mesh.rows)};
      const paving::GroundPoint ground = paving::settlement(pavement.ground, seed, place);
      append_stone_point(mesh.vertices, {place.x, place.y, paving::bed_level_mm(pavement) + ground.height_mm});
      append_stone_point(mesh.normals, glm::normalize(vec3{-ground.slope.x, -ground.slope.y, 1.0}));
    }
  }
  for (std::size_t row = 0; row < mesh.rows; ++row) {
    for (std::size_t column = 0; column < mesh.columns; ++column) {
      const std::size_t a = row * (mesh.columns + 1) + column;
      const std::size_t b = a + mesh.columns + 1;
      mesh.faces += fmt::format("<{},{},{}><{},{},{}>", a, a + 1, b + 1, a, b + 1, b);
    }
  }
  return mesh;
}

}  // namespace

void append_bounds(std::string& text, const std::string& prefix, const paving::Pavement& pavement, double stone_size_mm) {
  const geometry::Box box = geometry::bounding_box(pavement.area.outline);
  text += fmt::format("#declare {}_Bed_Level = {};\n#declare {}_Top = {};\n", prefix, rounded(paving::bed_level_mm(pavement)),
                      prefix, rounded(paving::top_mm(pavement)));
  text += fmt::format("#declare {}_Stone_Size = {};\n", prefix, rounded(stone_size_mm));
  const vec2 slope = paving::fall(pavement.ground);
  const double level = pavement.ground.level_mm;
  const auto least = [&](bool most) {
    const auto end = [&](double s, double low, double high) { return s * ((s > 0.0) == most ? high : low); };
    return level + end(slope.x, box.low.x, box.high.x) + end(slope.y, box.low.y, box.high.y);
  };
  text += fmt::format("#declare {}_Min = ", prefix);
  append_stone_point(text, {box.low.x, box.low.y, least(false) - pavement.ground.depth_mm - pavement.ground.settlement_mm});
  text += fmt::format(";\n#declare {}_Max = ", prefix);
  append_stone_point(text, {box.high.x, box.high.y, least(true) + paving::top_mm(pavement)});
  text += ";\n\n";
}

void append_bed(std::string& text, const std::string& prefix, const paving::Pavement& pavement, std::uint64_t seed) {
  text += fmt::format("#declare {}_Bed =\n", prefix);
  const double sunken = pavement.ground.settlement_mm;
  const std::string last = fmt::format("   {}_Bed_Texture()\n", prefix) + ground_transform(pavement);
  if (sunken == 0.0) {
    append_prism(text, pavement, fmt::format("-{}", pavement.ground.depth_mm), prefix + "_Bed_Level", last);
  } else {
    const Mesh mesh = sunken_surface(pavement, seed);
    const std::size_t count = (mesh.columns + 1) * (mesh.rows + 1);
    text += "union {\n";
    append_prism(text, pavement, fmt::format("-{}", rounded(pavement.ground.depth_mm + sunken)),
                 fmt::format("{}_Bed_Level - {}", prefix, rounded(sunken)), "");
    text += fmt::format(
        "mesh2 {{\nvertex_vectors {{ {}, {} }}\nnormal_vectors {{ {}, {} }}\nface_indices {{ {}, {} }}\nclipped_by {{\n", count,
        mesh.vertices, count, mesh.normals, 2 * mesh.columns * mesh.rows, mesh.faces);
    append_prism(text, pavement, fmt::format("-{}", rounded(pavement.ground.depth_mm + sunken)), prefix + "_Top", "");
    text += "} }\n" + last + "}\n";
  }
  text += "\n";
}

std::string water_text(const paving::Pavement& pavement, const std::string& prefix, std::span<const StoneText> stones) {
  std::vector<double> faces;
  faces.reserve(stones.size());
  for (const StoneText& stone : stones) faces.push_back(stone.face_mm);
  const std::optional<double> water = paving::water_level_mm(pavement.look, std::move(faces));
  if (!water) return {};
  const double level = rounded(*water);
  std::string text = fmt::format("#declare {}_Water =\n", prefix);
  append_prism(text, pavement, fmt::format("-{}", rounded(pavement.ground.depth_mm + pavement.ground.settlement_mm)),
               fmt::format("{}", level), "   Shatterpave_Water()\n" + ground_transform(pavement));
  return text + "\n";
}

std::string ground_transform(const paving::Pavement& pavement) {
  const vec2 slope = paving::fall(pavement.ground);
  if (slope == vec2{0.0, 0.0} && pavement.ground.level_mm == 0.0) return {};
  return fmt::format("   matrix <1, {}, 0, 0, 1, 0, 0, {}, 1, 0, {}, 0>\n", slope.x, slope.y, pavement.ground.level_mm);
}

}  // namespace shatterpave::exporting::povray
