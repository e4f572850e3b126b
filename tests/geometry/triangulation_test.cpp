#include "geometry/triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/angle.h"
#include "core/random.h"
#include "geometry/planar_map.h"
#include "geometry/predicates.h"

namespace shatterpave::geometry {
namespace {

using Ring = std::vector<LatticePoint>;
using Rings = std::vector<Ring>;

// Twice the area of the rings, and what is wrong with the triangles: exact, by their edges alone. Triangles none of which is
// turned over, whose inner edges meet their like and whose other edges are the rings, tile what the rings enclose.
std::int64_t area_of(const Rings& rings) {
  std::int64_t sum = 0;
  for (const Ring& ring : rings) sum += doubled_area(ring);
  return sum;
}

std::string fault_of(const Rings& rings, const std::vector<TriangleCorners>& triangles) {
  Ring points;
  std::multiset<std::pair<std::size_t, std::size_t>> open;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) open.insert({points.size() + (i + 1) % ring.size(), points.size() + i});
    points.insert(points.end(), ring.begin(), ring.end());
  }
  if (triangles.size() != points.size() + 2 * rings.size() - 4) return "a wrong number of triangles";
  std::int64_t sum = 0;
  for (const auto& [a, b, c] : triangles) {
    if (side(points[a], points[b], points[c]) != Side::left) return "a triangle without area, or turned over";
    sum += doubled_area(Ring{points[a], points[b], points[c]});
    open.insert({a, b});
    open.insert({b, c});
    open.insert({c, a});
  }
  if (sum != area_of(rings)) return "areas that do not add up";
  for (const auto& [a, b] : open) {
    if (open.count({a, b}) != 1 || open.count({b, a}) != 1) return "an edge without its like";
  }
  return "";
}

TEST(Triangulation, TilesARegionWithHolesAndStraightCorners) {
  const Rings rings = {{{0, 0}, {50, 0}, {100, 0}, {100, 50}, {100, 100}, {0, 100}},
                       {{20, 20}, {20, 40}, {40, 40}, {40, 20}},
                       {{60, 60}, {60, 80}, {70, 80}, {80, 80}, {80, 60}},
                       {{60, 20}, {70, 40}, {80, 20}}};
  EXPECT_EQ(fault_of(rings, triangulation(rings)), "");
}

// The check is not blind: a triangle too few, one turned over, one in place of another.
TEST(Triangulation, CheckSeesFaults) {
  const Rings rings = {{{0, 0}, {100, 0}, {100, 100}, {0, 100}}};
  EXPECT_EQ(fault_of(rings, {{0, 1, 2}, {0, 2, 3}}), "");
  EXPECT_NE(fault_of(rings, {{0, 1, 2}}), "");
  EXPECT_NE(fault_of(rings, {{0, 1, 2}, {0, 3, 2}}), "");
  EXPECT_NE(fault_of(rings, {{0, 1, 2}, {0, 1, 3}}), "");
}

// A star about (0, 0), with as many corners, some of them needles.
Ring star(std::uint64_t seed, int corners, double least_mm, double most_mm) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double u = uniform(seed, {Stream::turn, Id("star"), static_cast<std::uint32_t>(i)});
    const double radius = least_mm + (most_mm - least_mm) * u * u;
    ring.push_back(to_lattice(radius * Angle::degrees(360.0 * i / corners).direction()));
  }
  return ring;
}

TEST(Triangulation, TilesStarsWithStarsInThem) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const int corners = 5 + static_cast<int>(seed) * 2;
    Rings rings = {star(seed, corners, 10.0, 100.0), star(seed + 1000, corners, 0.01, 9.0)};
    std::ranges::reverse(rings[1]);
    EXPECT_EQ(fault_of(rings, triangulation(rings)), "") << "star " << seed;
  }
}

// What a bevel is: a ring 20 µm wide about a shape with needles.
TEST(Triangulation, TilesThinRings) {
  const Ring outer = star(3, 200, 50.0, 100.0);
  Ring inner = outer;
  for (LatticePoint& p : inner) p = {p.x - p.x / 1000, p.y - p.y / 1000};
  std::ranges::reverse(inner);
  const Rings rings = {outer, inner};
  EXPECT_EQ(fault_of(rings, triangulation(rings)), "");
}

}  // namespace
}  // namespace shatterpave::geometry
