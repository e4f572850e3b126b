#include "geometry/plane_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/angle.h"
#include "core/random.h"
#include "core/vec.h"
#include "geometry/polygon.h"
#include "geometry/predicates.h"

namespace shatterpave::geometry {
namespace {

using Ring = std::vector<LatticePoint>;

std::int64_t doubled(const PlaneMesh& mesh) {
  std::int64_t sum = 0;
  for (const auto& [a, b, c] : mesh.triangles()) {
    const LatticePoint p = mesh.points()[a];
    const LatticePoint q = mesh.points()[b];
    const LatticePoint r = mesh.points()[c];
    EXPECT_EQ(side(p, q, r), Side::left);
    sum += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }
  return sum;
}

// Stars with a star-shaped hole.
std::vector<Ring> random_rings(std::uint64_t seed) {
  std::uint32_t next = 0;
  const auto draw = [&] { return uniform(seed, {Stream::turn, Id("rings"), next++}); };
  const auto star = [&](double least, double most) {
    Ring ring;
    const int corners = 5 + static_cast<int>(20.0 * draw());
    for (int i = 0; i < corners; ++i) {
      const Angle direction = Angle::degrees(360.0 * (i + 0.8 * draw()) / corners);
      ring.push_back(to_lattice((least + (most - least) * draw()) * direction.direction()));
    }
    return ring;
  };
  std::vector<Ring> rings{star(20.0, 100.0), star(2.0, 10.0)};
  std::ranges::reverse(rings[1]);
  return rings;
}

// Whether d lies within the circle about a b c, by another way than the mesh's: the distance to its centre.
bool in_circle(vec2 a, vec2 b, vec2 c, vec2 d) {
  const vec2 p = b - a;
  const vec2 q = c - a;
  const vec2 centre =
      vec2{q.y * glm::dot(p, p) - p.y * glm::dot(q, q), p.x * glm::dot(q, q) - q.x * glm::dot(p, p)} / (2.0 * cross(p, q));
  return glm::length(d - a - centre) < glm::length(centre) * (1.0 - 1e-9);
}

TEST(PlaneMesh, BecomesADelaunayTriangulationOfTheSameRegion) {
  std::size_t changed = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    PlaneMesh mesh(random_rings(seed));
    const std::int64_t area = doubled(mesh);
    const std::size_t count = mesh.triangles().size();
    const std::vector<TriangleCorners> ears = mesh.triangles();
    mesh.make_delaunay();
    EXPECT_EQ(doubled(mesh), area);
    EXPECT_EQ(mesh.triangles().size(), count);
    if (mesh.triangles() != ears) ++changed;
    const auto at = [&](std::size_t v) { return to_mm(mesh.points()[v]); };
    for (const TriangleCorners& corners : mesh.triangles()) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto apex = mesh.apex(corners[(i + 1) % 3], corners[i]);
        EXPECT_FALSE(apex && in_circle(at(corners[0]), at(corners[1]), at(corners[2]), at(*apex))) << seed;
      }
    }
  }
  EXPECT_GT(changed, 90U);
}

// A square of 10 µm in two triangles.
PlaneMesh square() { return PlaneMesh(std::vector<Ring>{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}); }

std::array<std::size_t, 2> diagonal(const PlaneMesh& mesh) {
  return mesh.apex(0, 2) ? std::array<std::size_t, 2>{0, 2} : std::array<std::size_t, 2>{1, 3};
}

TEST(PlaneMesh, FlipsADiagonalButNoSide) {
  PlaneMesh mesh = square();
  const auto [a, b] = diagonal(mesh);
  EXPECT_FALSE(mesh.flip(0, 1));
  EXPECT_TRUE(mesh.flip(a, b));
  EXPECT_NE(diagonal(mesh)[0], a);
  EXPECT_EQ(doubled(mesh), 200);
}

// An arrow head: its only inner edge cannot be flipped.
TEST(PlaneMesh, FlipsNothingThatIsNotConvex) {
  PlaneMesh mesh(std::vector<Ring>{{{0, 0}, {10, -10}, {4, 0}, {10, 10}}});
  EXPECT_TRUE(mesh.apex(0, 2));
  EXPECT_FALSE(mesh.flip(0, 2));
  mesh.make_delaunay();
  EXPECT_TRUE(mesh.apex(0, 2));
}

TEST(PlaneMesh, PartsEdgesAndTriangles) {
  PlaneMesh mesh = square();
  const auto [a, b] = diagonal(mesh);
  EXPECT_FALSE(mesh.part(a, b, {20, 5}));
  EXPECT_FALSE(mesh.part(0, 1, {5, 0}));
  EXPECT_EQ(mesh.part(a, b, {5, 5}), std::optional<std::size_t>(4));
  EXPECT_EQ(mesh.triangles().size(), 4U);
  EXPECT_EQ(doubled(mesh), 200);
  const auto below = mesh.triangle_at(0, 1);
  ASSERT_TRUE(below);
  EXPECT_FALSE(mesh.part(*below, {5, 0}));
  EXPECT_FALSE(mesh.part(*below, {5, 9}));
  EXPECT_EQ(mesh.part(*below, {5, 2}), std::optional<std::size_t>(5));
  EXPECT_EQ(mesh.triangles().size(), 6U);
  EXPECT_EQ(doubled(mesh), 200);
}

// Coordinates as far apart as scenes allow.
TEST(PlaneMesh, IsExactOverTwoKilometres) {
  constexpr std::int64_t far = 1'000'000'000;
  PlaneMesh mesh(std::vector<Ring>{{{-far, -far}, {0, -far}, {far, -far}, {far, far}, {0, far - 1}, {-far, far}}});
  mesh.make_delaunay();
  EXPECT_EQ(mesh.triangles().size(), 4U);
  EXPECT_TRUE(mesh.apex(1, 4) && mesh.apex(4, 1));
}

}  // namespace
}  // namespace shatterpave::geometry
