#include "face/stone_maker.h"

#include <cmath>

#include "export/shapes/stone_mesh.h"
#include "export/shapes/stone_relief.h"
#include "face/plain.h"
#include "paving/surface/ground.h"

namespace shatterpave::face {

namespace {

namespace shapes = exporting::shapes;

// With the fall and the level of the ground: a shear along z.
Point3 on_ground(const vec3& p, const paving::Ground& ground, vec2 slope) {
  return {p.x, p.y, p.z + ground.level_mm + slope.x * p.x + slope.y * p.y};
}

Point3 normal_on_ground(const vec3& n, vec2 slope) {
  return plain(glm::normalize(vec3{n.x - slope.x * n.z, n.y - slope.y * n.z, n.z}));
}

}  // namespace

StoneMaker::StoneMaker(const exporting::PavedArea& paved, std::uint64_t seed)
    : paved_(paved), surface_(paved.pavement, paved.layout.stones, seed) {
  const relief::FractalSurface relief = shapes::stone_relief(paved.pavement);
  relief_side_mm_ = relief.spacing_mm * static_cast<double>(relief.size);
  if (paved.pavement.relief.rms_mm > 0.0) relief_ = shapes::stone_relief_heights(paved.pavement, seed);
}

StoneMesh StoneMaker::mesh(std::size_t stone, const StoneMeshOptions& options) const {
  const vec2 centre = geometry::centroid(paved_.layout.stones[stone].outline_mm);
  const paving::StoneDraws draws = surface_.draws(stone);
  const bool has_relief = options.relief && !relief_.heights_mm.empty();
  const shapes::ReliefWindow window{has_relief ? &relief_ : nullptr, draws.relief_place, centre, relief_side_mm_, draws.relief};
  const shapes::StoneMesh made = shapes::displaced(surface_.patches(stone, draws), window, options.step_mm);
  const paving::Ground& ground = paved_.pavement.ground;
  const vec2 slope = paving::fall(ground);
  StoneMesh mesh;
  mesh.vertices_mm.reserve(made.vertices.size());
  for (const vec3& vertex : made.vertices) mesh.vertices_mm.push_back(on_ground(vertex, ground, slope));
  mesh.normals.reserve(made.normals.size());
  for (const vec3& normal : made.normals) mesh.normals.push_back(normal_on_ground(normal, slope));
  mesh.triangles.reserve(made.triangles.size() / 3);
  for (std::size_t i = 0; i + 2 < made.triangles.size(); i += 3) {
    mesh.triangles.push_back({made.triangles[i], made.triangles[i + 1], made.triangles[i + 2]});
  }
  return mesh;
}

}  // namespace shatterpave::face
