#include "export/shapes/stone_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "paving/surface/stone_surface.h"
#include "relief/fractal_surface.h"

namespace shatterpave::exporting::shapes {
namespace {

using geometry::BezierPatch;
using geometry::Polygon;

const Polygon square = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
const Polygon pentagon = {{0, 0}, {100, 0}, {100, 60}, {60, 100}, {0, 100}};

std::vector<BezierPatch> chipped_body(const Polygon& outline) {
  paving::BodyDraws draws;
  draws.arris_mm = 6.0;
  draws.rise_mm = 20.0;
  draws.crown_mm = 2.0;
  draws.chips_per_m = 1.0;
  draws.chips[0] = {0.0, 0.3, 0.7};
  draws.chips[1] = {0.0, 0.8, 0.2};
  return paving::body_patches(outline, draws, {});
}

relief::HeightField rough() { return relief::fractal_surface({64, 8.0, 1.5, 0.6, 100.0}, 7, Id("rough")); }

using Key = std::tuple<long long, long long, long long>;

// To 1 µm, as the text has it.
Key key(const vec3& p) { return {std::llround(1e3 * p.x), std::llround(1e3 * p.y), std::llround(1e3 * p.z)}; }

// Sides of triangles that no other triangle has the other way round, beyond those at the foot.
int cracks(const StoneMesh& mesh, double foot_mm) {
  std::map<std::pair<Key, Key>, int> sides;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++sides[{key(mesh.vertices[mesh.triangles[i + k]]), key(mesh.vertices[mesh.triangles[i + (k + 1) % 3]])}];
    }
  }
  int open = 0;
  for (const auto& [side, count] : sides) {
    const auto back = sides.find({side.second, side.first});
    const bool at_foot =
        std::get<2>(side.first) < std::llround(1e3 * foot_mm) && std::get<2>(side.second) < std::llround(1e3 * foot_mm);
    if ((back == sides.end() || back->second != count) && !at_foot) ++open;
  }
  return open;
}

TEST(StoneMesh, DisplacedBodyHasNoCrack) {
  const relief::HeightField field = rough();
  for (const Polygon& outline : {square, pentagon}) {
    const ReliefWindow window{&field, {0.3, 0.6}, {50, 50}, 512.0, 1.0};
    const StoneMesh mesh = displaced(chipped_body(outline), window, 2.5);
    EXPECT_GT(mesh.triangles.size(), 3000U);
    EXPECT_EQ(cracks(mesh, 8.0), 0);
  }
}

TEST(StoneMesh, CrackTestSeesACrack) {
  const relief::HeightField field = rough();
  const ReliefWindow window{&field, {0.3, 0.6}, {50, 50}, 512.0, 1.0};
  StoneMesh mesh = displaced(chipped_body(square), window, 2.5);
  // A vertex that stands twice, once for each of the patches that meet there, and not at the foot.
  std::map<Key, int> times;
  for (const vec3& vertex : mesh.vertices) ++times[key(vertex)];
  const auto shared = std::ranges::find_if(mesh.vertices, [&](const vec3& v) { return v.z > 15.0 && times[key(v)] == 2; });
  ASSERT_NE(shared, mesh.vertices.end());
  shared->z += 0.01;
  EXPECT_GT(cracks(mesh, 8.0), 0);
}

TEST(StoneMesh, IsLiftedByTheReliefAlone) {
  const relief::HeightField field = rough();
  const std::vector<BezierPatch> patches = chipped_body(square);
  const StoneMesh level = displaced(patches, {nullptr, {0, 0}, {50, 50}, 512.0, 1.0}, 2.5);
  const StoneMesh lifted = displaced(patches, {&field, {0, 0}, {50, 50}, 512.0, 1.0}, 2.5);
  const StoneMesh half = displaced(patches, {&field, {0, 0}, {50, 50}, 512.0, 0.5}, 2.5);
  ASSERT_EQ(level.vertices.size(), lifted.vertices.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < level.vertices.size(); ++i) {
    const vec3 moved = lifted.vertices[i] - level.vertices[i];
    EXPECT_EQ(moved.x, 0.0);
    EXPECT_EQ(moved.y, 0.0);
    EXPECT_NEAR(half.vertices[i].z - level.vertices[i].z, 0.5 * moved.z, 1e-9);
    squares += moved.z * moved.z;
  }
  // A window of a fifth of the field has most of its roughness; bilinear interpolation takes a little.
  const double rms = std::sqrt(squares / static_cast<double>(level.vertices.size()));
  EXPECT_GT(rms, 0.6);
  EXPECT_LT(rms, 2.5);
}

TEST(StoneMesh, NormalsAreThoseOfTheLiftedSurface) {
  const relief::HeightField field = rough();
  const StoneMesh mesh = displaced(chipped_body(square), {&field, {0.3, 0.6}, {50, 50}, 512.0, 1.0}, 0.5);
  int steep = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const vec3& a = mesh.vertices[mesh.triangles[i]];
    const vec3 face = glm::cross(mesh.vertices[mesh.triangles[i + 1]] - a, mesh.vertices[mesh.triangles[i + 2]] - a);
    if (a.x < 10 || a.x > 90 || a.y < 10 || a.y > 90) continue;
    // On the face triangles of half a millimetre are nearly the tangent planes, but for those across a line of the field.
    const vec3 mean = glm::normalize(mesh.normals[mesh.triangles[i]] + mesh.normals[mesh.triangles[i + 1]] +
                                     mesh.normals[mesh.triangles[i + 2]]);
    if (glm::dot(glm::normalize(face), mean) < 0.98) ++steep;
  }
  EXPECT_LT(steep, static_cast<int>(mesh.triangles.size() / 3 / 20));
}

TEST(StoneMesh, PrismStandsWhereThePatchesDo) {
  const std::vector<BezierPatch> patches = chipped_body(pentagon);
  const StoneMesh mesh = prism(pentagon, patches, 6.0);
  ASSERT_EQ(mesh.vertices.size(), 11U);
  EXPECT_EQ(mesh.triangles.size(), 3U * 15U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(vec2(mesh.vertices[i].x, mesh.vertices[i].y), pentagon[i]);
  EXPECT_NEAR(mesh.vertices.back().z, 22.0, 0.1);
  EXPECT_EQ(cracks(mesh, 8.0), 0);
}

}  // namespace
}  // namespace shatterpave::exporting::shapes
