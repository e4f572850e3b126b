#include "geometry/polygon.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/angle.h"
#include "core/error.h"
#include "core/random.h"
#include "geometry/lattice.h"

namespace shatterpave::geometry {
namespace {

std::int64_t drawn(std::uint32_t polygon, std::uint32_t draw, std::int64_t low, std::int64_t high) {
  const double u = uniform(9, {Stream::turn, Id("polygon").child(polygon), draw});
  return low + static_cast<std::int64_t>(u * static_cast<double>(high - low + 1));
}

// A simple polygon of the lattice, counter-clockwise: two chains over the same ascending x, the lower one below the upper.
std::vector<LatticePoint> two_chains(std::uint32_t seed) {
  const std::int64_t middles = drawn(seed, 0, 1, 6);
  std::vector<LatticePoint> lower = {{-3, drawn(seed, 1, -9, 9)}};
  std::vector<LatticePoint> upper;
  std::int64_t x = lower.front().x;
  for (std::int64_t i = 0; i < middles; ++i) {
    const auto draw = static_cast<std::uint32_t>(10 * (i + 1));
    x += drawn(seed, draw, 1, 5);
    const std::int64_t y = drawn(seed, draw + 1, -9, 9);
    lower.push_back({x, y});
    upper.push_back({x, y + drawn(seed, draw + 2, 1, 9)});
  }
  lower.push_back({x + drawn(seed, 2, 1, 5), drawn(seed, 3, -9, 9)});
  lower.insert(lower.end(), upper.rbegin(), upper.rend());
  return lower;
}

Polygon in_mm(const std::vector<LatticePoint>& points) {
  Polygon polygon;
  for (const LatticePoint& point : points) polygon.push_back(to_mm(point));
  return polygon;
}

std::int64_t border_points(const std::vector<LatticePoint>& points) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LatticePoint& next = points[(i + 1) % points.size()];
    count += std::gcd(next.x - points[i].x, next.y - points[i].y);
  }
  return count;
}

std::int64_t points_within(const Polygon& polygon) {
  std::int64_t count = 0;
  for (std::int64_t x = -5; x <= 40; ++x) {
    for (std::int64_t y = -20; y <= 30; ++y) count += contains(polygon, to_mm(LatticePoint{x, y})) ? 1 : 0;
  }
  return count;
}

// Whether the directions to the vertices run round `p` once, by the sum of angles: p must not lie on the border.
bool oracle_contains(const Polygon& polygon, vec2 p) {
  double turns = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    turns += (Angle::of(polygon[(i + 1) % polygon.size()] - p) - Angle::of(polygon[i] - p)).wrapped().radians() / (2.0 * pi);
  }
  return std::abs(turns) > 0.5;
}

const Polygon small_square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};

// Pick's theorem: area = inner points + half the border points - 1, in units of the lattice. Exact, and it binds area and
// contains together.
TEST(Polygon, KeepsPicksTheorem) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const std::vector<LatticePoint> points = two_chains(seed);
    const std::int64_t border = border_points(points);
    const std::int64_t inner = points_within(in_mm(points)) - border;
    const double expected = static_cast<double>(inner) + 0.5 * static_cast<double>(border) - 1.0;
    ASSERT_NEAR(area(in_mm(points)) * lattice_per_mm * lattice_per_mm, expected, 1e-6) << seed;
  }
}

TEST(Polygon, ContainsAgreesWithTheSumOfAngles) {
  int inside = 0;
  int outside = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    const Polygon polygon = in_mm(two_chains(seed));
    for (std::uint32_t i = 0; i < 100; ++i) {
      const vec2 p = to_mm(LatticePoint{drawn(seed, 200 + i, -5, 30), drawn(seed, 300 + i, -10, 20)});
      bool on_border = false;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const vec2 a = polygon[k] - p;
        const vec2 b = polygon[(k + 1) % polygon.size()] - p;
        on_border = on_border || (std::abs(cross(a, b)) < 1e-12 && glm::dot(a, b) <= 0.0);
      }
      if (on_border) {
        EXPECT_TRUE(contains(polygon, p));
        continue;
      }
      ASSERT_EQ(contains(polygon, p), oracle_contains(polygon, p)) << seed;
      ++(contains(polygon, p) ? inside : outside);
    }
  }
  EXPECT_GT(inside, 500);
  EXPECT_GT(outside, 500);
}

TEST(Polygon, AreaIsSignedAndSmallFarFromTheOrigin) {
  EXPECT_EQ(area(small_square), 16.0);
  EXPECT_EQ(area(Polygon(small_square.rbegin(), small_square.rend())), -16.0);
  Polygon far = small_square;
  for (vec2& vertex : far) vertex = 0.001 * vertex + vec2{999000.0, -999000.0};
  EXPECT_NEAR(area(far), 16e-6, 1e-12);
}

TEST(Polygon, CentroidAndBox) {
  EXPECT_EQ(centroid(small_square), (vec2{2.0, 2.0}));
  EXPECT_EQ(centroid({{0, 0}, {3, 0}, {0, 6}}), (vec2{1.0, 2.0}));
  // An L of three unit squares: the mean of their centres, in either winding.
  const Polygon corner = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  EXPECT_NEAR(centroid(corner).x, 2.5 / 3.0, 1e-15);
  EXPECT_NEAR(centroid(Polygon(corner.rbegin(), corner.rend())).y, 2.5 / 3.0, 1e-15);
  EXPECT_EQ(centroid({{1, 1}, {2, 2}}), (vec2{1.0, 1.0})) << "without an area, its first vertex";
  EXPECT_EQ(bounding_box(corner).low, (vec2{0.0, 0.0}));
  EXPECT_EQ(bounding_box(corner).high, (vec2{2.0, 2.0}));
  EXPECT_THROW(static_cast<void>(bounding_box({})), BrokenInvariant);
}

TEST(Region, LeavesOutTheInsideOfItsHoles) {
  const Region region{small_square, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}};
  EXPECT_EQ(area(region), 15.0);
  EXPECT_TRUE(contains(region, {0.5, 0.5}));
  EXPECT_TRUE(contains(region, {1.0, 1.5})) << "the border of a hole belongs to the region";
  EXPECT_TRUE(contains(region, {4.0, 4.0})) << "and so does that of the outline";
  EXPECT_FALSE(contains(region, {1.5, 1.5}));
  EXPECT_FALSE(contains(region, {1.001, 1.001})) << "a micrometre inside the hole";
  EXPECT_FALSE(contains(region, {4.001, 2.0}));
}

}  // namespace
}  // namespace shatterpave::geometry
