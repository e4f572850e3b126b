#include "geometry/region_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/random.h"
#include "geometry/delaunay.h"
#include "geometry/predicates.h"

namespace shatterpave::geometry {
namespace {

double draw(std::uint32_t i) { return uniform(5, {Stream::stone_seed, Id("region index test"), i}); }

// A star with a square hole, on a coarse lattice so that points fall on its border.
Region star() {
  Region region;
  for (int i = 0; i < 40; ++i) {
    const Angle at = Angle::degrees(9.0 * i);
    const vec2 p = (i % 2 == 0 ? 100.0 : 55.0) * at.direction();
    region.outline.push_back({std::round(p.x), std::round(p.y)});
  }
  region.holes = {{{-20, -20}, {-20, 20}, {20, 20}, {20, -20}}};
  return region;
}

TEST(RegionIndex, AgreesWithBruteForce) {
  const Region region = star();
  const RegionIndex index(region);
  int inside = 0;
  int on_border = 0;
  for (std::uint32_t i = 0; i < 4000; ++i) {
    const vec2 p{std::round(240.0 * draw(2 * i) - 120.0), std::round(240.0 * draw(2 * i + 1) - 120.0)};
    EXPECT_EQ(index.contains(p), contains(region, p)) << p.x << ' ' << p.y;
    double nearest = 1e300;
    std::size_t within = 0;
    for (const auto& segment : index.segments()) {
      const vec2 d = nearest_point(segment, p) - p;
      nearest = std::min(nearest, std::sqrt(glm::dot(d, d)));
      within += glm::dot(d, d) <= 400.0 ? 1U : 0U;
    }
    EXPECT_EQ(index.nearest(p).distance_mm, nearest);
    EXPECT_EQ(index.border_within(p, 7.0), nearest <= 7.0);
    std::vector<std::size_t> found;
    index.near(p, 20.0, found);
    EXPECT_EQ(found.size(), within);
    inside += index.contains(p) ? 1 : 0;
    on_border += nearest == 0.0 ? 1 : 0;
  }
  EXPECT_GT(inside, 800);
  EXPECT_GT(on_border, 8);
}

TEST(RegionIndex, BorderMeetsBoxesThatItPassesThrough) {
  const RegionIndex index({{{0, 0}, {100, 0}, {0, 100}}, {}});
  EXPECT_TRUE(index.border_meets({{40, 40}, {60, 60}}));   // the slope, no corner inside
  EXPECT_TRUE(index.border_meets({{-10, -10}, {0, 0}}));   // touches a corner
  EXPECT_FALSE(index.border_meets({{10, 10}, {30, 30}}));  // wholly inside
  EXPECT_FALSE(index.border_meets({{80, 80}, {90, 90}}));  // within its box, beyond the slope
}

TEST(Delaunay, NoPointLiesInsideTheCircleOfAFace) {
  std::vector<vec2> points;
  for (std::uint32_t i = 0; i < 60; ++i) points.push_back(on_lattice(vec2{100.0 * draw(2 * i), 100.0 * draw(2 * i + 1)}));
  const Delaunay mesh = delaunay(points);
  std::vector<std::vector<std::size_t>> corners(mesh.face_count);
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (const auto& spoke : mesh.around(p)) {
      if (spoke.face != Delaunay::none) corners[spoke.face].push_back(p);
    }
  }
  for (const auto& face : corners) {
    ASSERT_EQ(face.size(), 3U);
    const vec2 a = points[face[0]];
    const vec2 b = points[face[1]] - a;
    const vec2 c = points[face[2]] - a;
    const vec2 centre = a + vec2{c.y * glm::dot(b, b) - b.y * glm::dot(c, c), b.x * glm::dot(c, c) - c.x * glm::dot(b, b)} /
                                (2.0 * cross(b, c));
    const double radius = std::sqrt(glm::dot(a - centre, a - centre));
    for (const vec2& p : points) EXPECT_GE(std::sqrt(glm::dot(p - centre, p - centre)), radius - 1e-6);
  }
}

TEST(Delaunay, GridHasFacesOfThreeOrFourCorners) {
  std::vector<vec2> points;
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) points.push_back({10.0 * x, 10.0 * y});
  }
  const Delaunay mesh = delaunay(points);
  // The middle has its four neighbours, counter-clockwise, perhaps with diagonals between them.
  std::vector<std::uint32_t> sides;
  for (const auto& spoke : mesh.around(12)) {
    if (spoke.neighbour == 13 || spoke.neighbour == 17 || spoke.neighbour == 11 || spoke.neighbour == 7) {
      sides.push_back(spoke.neighbour);
    }
  }
  std::rotate(sides.begin(), std::ranges::find(sides, 13U), sides.end());
  EXPECT_EQ(sides, (std::vector<std::uint32_t>{13, 17, 11, 7}));
}

}  // namespace
}  // namespace shatterpave::geometry
