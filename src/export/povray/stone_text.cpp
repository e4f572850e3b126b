#include "export/povray/stone_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "export/shapes/stone_mesh.h"
#include "export/shapes/tones.h"
#include "geometry/lattice.h"
#include "paving/surface/laid_surface.h"
#include "paving/surface/stone_surface.h"

namespace shatterpave::exporting::povray {

namespace {

using geometry::BezierPatch;
using paving::StoneDraws;

// Five decimals of an image that is five stones wide: a two-hundredth of its pixel.
void append_texture_place(std::string& text, vec2 place) {
  text += '<';
  append_decimal(text, std::llround(place.x * 1e5), 5);
  text += ',';
  append_decimal(text, std::llround(place.y * 1e5), 5);
  text += '>';
}

void append_patch(std::string& text, const BezierPatch& patch, const std::array<vec2, 4>& texture_corners,
                  std::string_view kind) {
  text += kind;
  for (const vec2& corner : texture_corners) append_texture_place(text, corner);
  for (const vec3& point : patch.control_points) append_stone_point(text, point);
  text += "}\n";
}

// ---- places on the texture

constexpr double least_flank_mm = 30.0;

// Of the corners of a patch, mm: where they lie in the plan. The flanks of what stands free would be drawn out along their
// height: they are folded out about their upper edge, the inner one.
std::array<vec2, 4> plan_places(const BezierPatch& patch) {
  const auto& points = patch.control_points;
  const auto plan = [&](std::size_t i) { return vec2{points[i].x, points[i].y}; };
  std::array<vec2, 4> places = {plan(0), plan(3), plan(15), plan(12)};
  const double first_drop = points[3].z - points[0].z;
  const double last_drop = points[15].z - points[12].z;
  if (std::min(first_drop, last_drop) < least_flank_mm || places[1] == places[2]) return places;
  const vec2 outwards = -left_of(glm::normalize(places[2] - places[1]));
  places[0] = places[1] + first_drop * outwards;
  places[3] = places[2] + last_drop * outwards;
  return places;
}

// ---- by distance

enum class Form { mesh, patches, prism };

struct Fineness {
  Form form = Form::patches;
  std::string kind = "bicubic_patch{type 0 flatness 0 u_steps K v_steps K uv_vectors";
  bool chips = true;  // near enough to be seen
};

// Distances are in sizes of the stone, since it is the angle under which it is seen that counts. With 2^steps parts a side at
// these distances a part takes some 1/100 of the distance, 0.6°: ten pixels of a picture, on a curve too flat to show them.
Fineness fineness(const paving::Pavement& pavement, vec2 centre, double size_mm) {
  if (!pavement.detail) return {};
  const paving::Detail& detail = *pavement.detail;
  const double distance = glm::length(centre - detail.viewer_mm);
  if (distance <= detail.close_mm) return {Form::mesh, {}, true};
  const double sizes = distance / size_mm;
  if (sizes > 80.0) return {Form::prism, {}, false};
  int steps = sizes < 12.0 ? 4 : (sizes < 40.0 ? 3 : 2);
  if (pavement.body.finish != paving::Finish::none) --steps;  // of several patches
  // Near ones are worth the memory of type 1, which keeps its parts.
  const bool near = sizes < 12.0;
  return {Form::patches,
          fmt::format("bicubic_patch{{type {} flatness 0 u_steps {} v_steps {} uv_vectors", near ? 1 : 0, steps, steps), near};
}

// ---- one stone

struct Making {
  const PavedArea& paved;
  double relief_side_mm = 1.0;
  const relief::HeightField* relief = nullptr;
  const paving::LaidSurface& surface;
};

void append_vertices(StoneText& result, const shapes::StoneMesh& mesh, double side_mm, vec2 centre, const StoneDraws& draws) {
  for (const vec3& vertex : mesh.vertices) {
    append_stone_point(result.vertices, vertex);
    append_texture_place(result.places, draws.relief_place + (vec2{vertex.x, vertex.y} - centre) / side_mm);
  }
  result.triangles = mesh.triangles;
  result.vertex_count = mesh.vertices.size();
}

std::string mesh_text(const shapes::StoneMesh& mesh, const std::string& vertices, const std::string& places) {
  std::string text =
      fmt::format("mesh2{{vertex_vectors{{{},{}}}normal_vectors{{{},", mesh.vertices.size(), vertices, mesh.normals.size());
  for (const vec3& normal : mesh.normals) append_stone_point(text, normal);
  text += fmt::format("}}uv_vectors{{{},{}}}face_indices{{{},", mesh.vertices.size(), places, mesh.triangles.size() / 3);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    text += fmt::format("<{},{},{}>", mesh.triangles[i], mesh.triangles[i + 2], mesh.triangles[i + 1]);
  }
  text += "}}\n";
  return text;
}

StoneText stone_text(const Making& making, std::size_t index) {
  const paving::Stone& stone = making.paved.layout.stones[index];
  const paving::Pavement& pavement = making.paved.pavement;
  const vec2 centre = geometry::centroid(stone.outline_mm);
  const double size_mm = std::sqrt(geometry::area(stone.outline_mm));
  StoneDraws draws = making.surface.draws(index);
  StoneText result;
  result.tone = shapes::tone_of(draws.colour) + shapes::stone_tones * std::max(0, stone.colour);
  result.wear = std::min(wear_classes - 1, static_cast<int>(making.surface.traffic(index) * wear_classes));
  const Fineness fine = fineness(pavement, centre, size_mm);
  if (!fine.chips && draws.body) draws.body->chips_per_m = 0.0;
  const std::vector<BezierPatch> patches = making.surface.patches(index, draws);
  result.face_mm = geometry::height_at(patches, centre);
  const auto texture_place = [&](vec2 p) { return draws.relief_place + (p - centre) / making.relief_side_mm; };
  if (fine.form == Form::patches) {
    for (const BezierPatch& patch : patches) {
      const std::array<vec2, 4> places = plan_places(patch);
      ++result.objects;
      append_patch(result.text, patch,
                   {texture_place(places[0]), texture_place(places[1]), texture_place(places[2]), texture_place(places[3])},
                   fine.kind);
    }
    return result;
  }
  if (fine.form == Form::prism) {
    append_vertices(result, shapes::prism(stone.outline_mm, patches, making.paved.pavement.body.arris_mm),
                    making.relief_side_mm, centre, draws);
    return result;
  }
  const shapes::ReliefWindow window{making.relief, draws.relief_place, centre, making.relief_side_mm, draws.relief};
  const shapes::StoneMesh mesh = shapes::displaced(patches, window, pavement.detail->mesh_mm);
  append_vertices(result, mesh, making.relief_side_mm, centre, draws);
  result.text = mesh_text(mesh, result.vertices, result.places);
  result.vertices.clear();
  result.places.clear();
  result.triangles.clear();
  result.vertex_count = 0;
  result.objects = 1;
  result.displaced = true;
  return result;
}

}  // namespace

double relief_of_wear(int wear) { return 1.0 - 0.5 * (wear + 0.5) / wear_classes; }

std::vector<StoneText> stone_texts(const PavedArea& paved, std::uint64_t seed, double relief_side_mm,
                                   const relief::HeightField* relief) {
  const paving::LaidSurface surface(paved.pavement, paved.layout.stones, seed);
  const Making making{paved, relief_side_mm, relief, surface};
  std::vector<StoneText> texts(paved.layout.stones.size());
  parallel_for_chunks(texts.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) texts[i] = stone_text(making, i);
  });
  return texts;
}

void append_decimal(std::string& text, std::int64_t units, int decimals) {
  if (units < 0) {
    text += '-';
    units = -units;
  }
  std::int64_t scale = 1;
  for (int i = 0; i < decimals; ++i) scale *= 10;
  text += std::to_string(units / scale);
  std::int64_t rest = units % scale;
  if (rest == 0) return;
  text += '.';
  while (rest != 0) {
    scale /= 10;
    text += static_cast<char>('0' + rest / scale);
    rest %= scale;
  }
}

void append_stone_point(std::string& text, vec3 mm) {
  text += '<';
  append_decimal(text, geometry::to_lattice(mm.x), 3);
  text += ',';
  append_decimal(text, geometry::to_lattice(mm.z), 3);
  text += ',';
  append_decimal(text, geometry::to_lattice(mm.y), 3);
  text += '>';
}

}  // namespace shatterpave::exporting::povray
