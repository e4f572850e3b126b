#include "export/povray/bent_glass.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string_view>

#include "core/angle.h"
#include "export/povray/sdl.h"
#include "export/shapes/mesh_parts.h"

namespace shatterpave::exporting::povray {

namespace {

// Neighbouring facets of bent glass differ by some thousandths: their normals are rounded to far less.
constexpr double bent_normal_steps = 1e5;
constexpr std::size_t lists_per_line = 6;
// As templates/includes/shatterpave_glass.inc has them.
constexpr double crumbs_reach = 1.25;
constexpr int powder_layers = 3;
constexpr double powder_spacing = 0.25;
constexpr std::size_t powder_sides = 48;

template <typename Put>
void append_mesh_list(std::string& text, std::string_view name, std::size_t count, const Put& put) {
  text += fmt::format("      {} {{ {},\n", name, count);
  for (std::size_t i = 0; i < count; ++i) {
    text += i == 0 ? "      " : (i % lists_per_line == 0 ? ",\n      " : ", ");
    put(i);
  }
  text += " }\n";
}

void append_points(std::string& text, const shapes::Mesh& mesh) {
  const auto rounded = [](double part) { return std::round(part * bent_normal_steps) / bent_normal_steps; };
  append_mesh_list(text, "vertex_vectors", mesh.points_mm.size(),
                   [&](std::size_t i) { append_standing_point(text, mesh.points_mm[i]); });
  append_mesh_list(text, "normal_vectors", mesh.normals.size(), [&](std::size_t i) {
    const vec3 n = mesh.normals[i];
    append_standing_point(text, {rounded(n.x), rounded(n.y), rounded(n.z)});
  });
}

// Slots: texture of each triangle from the first of them on; none: without textures.
void append_triangles(std::string& text, const shapes::Mesh& mesh, std::size_t first_broken, bool has_textures) {
  append_mesh_list(text, "face_indices", mesh.triangles.size() / 3, [&](std::size_t i) {
    fmt::format_to(std::back_inserter(text), "<{}, {}, {}>", mesh.triangles[3 * i], mesh.triangles[3 * i + 1],
                   mesh.triangles[3 * i + 2]);
    if (has_textures) text += i < first_broken ? ",0" : ",1";
  });
}

}  // namespace

std::string closed_mesh(const shapes::Mesh& mesh) {
  const shapes::Mesh once = shapes::welded(mesh);
  std::string text = "   mesh2 {\n";
  append_points(text, once);
  append_triangles(text, once, 0, false);
  return text + "      inside_vector z\n   }\n";
}

std::string shard_mesh_text(const glass::Shard& shard, const geometry::Bend& bend, double thickness_mm) {
  const auto part = [&](glass::ShardSurface surface) {
    return shapes::welded(shapes::bent(shapes::shard_mesh(shard, surface, thickness_mm), bend, shapes::bent_shard_bound_mm));
  };
  shapes::Mesh mesh = part(glass::ShardSurface::old);
  const std::size_t first_broken = mesh.triangles.size() / 3;
  shapes::append(mesh, part(glass::ShardSurface::broken));
  std::string text = "mesh2 {\n";
  append_points(text, mesh);
  text += "   texture_list { 2, texture { Old } texture { Broken } }\n";
  append_triangles(text, mesh, first_broken, true);
  return text;
}

std::string bend_declarations(const geometry::Bend& bend, const std::string& prefix) {
  return fmt::format("#declare {0}_Bend_Middle = {1};\n#declare {0}_Bend_Half = {2};\n#declare {0}_Bend_Bow = {3};\n\n", prefix,
                     standing_point({bend.middle_mm, 0.0}), standing_point({bend.half_mm, 0.0}),
                     standing_point({bend.bow_mm, 0.0}));
}

std::string bend_arguments(const std::string& prefix) {
  return fmt::format("{0}_Bend_Middle, {0}_Bend_Half, {0}_Bend_Bow", prefix);
}

std::string crushed_layers(const glass::ImpactZone& zone, const geometry::Bend& bend, double thickness_mm, std::size_t number) {
  geometry::Polygon round;
  for (std::size_t k = 0; k < powder_sides; ++k) {
    const Angle angle = Angle::degrees(360.0 * static_cast<double>(k) / static_cast<double>(powder_sides));
    round.push_back(geometry::on_lattice(zone.centre_mm + crumbs_reach * zone.radius_mm * angle.direction()));
  }
  std::string text = "   union {\n";
  for (int layer = 0; layer < powder_layers; ++layer) {
    // POV-Ray's z is turned round.
    const double z_mm = -(layer - 1) * powder_spacing * thickness_mm;
    const shapes::Mesh disc =
        shapes::welded(shapes::bent(shapes::upright_cap({round, {}}, z_mm), bend, shapes::bent_pane_bound_mm));
    text += "   mesh2 {\n";
    append_points(text, disc);
    append_triangles(text, disc, 0, false);
    text += fmt::format("      texture {{ Shatterpave_Crumbs_Layer({}, {}, {}) translate {} }}\n   }}\n",
                        povray::number(zone.radius_mm), number, layer, standing_point({zone.centre_mm, 0.0}));
  }
  return text + "   }\n";
}

}  // namespace shatterpave::exporting::povray
