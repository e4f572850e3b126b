#include "geometry/bend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace shatterpave::geometry {
namespace {

const Bend windscreen{{700, 400}, {700, 400}, {60, -20}};

// The numeric derivative of the map, for a step of 1e-2 mm: points are multiples of 1e-5 mm.
vec3 carried(const Bend& bend, vec3 at, vec3 along) {
  constexpr double step = 0.5;
  return (bend.point(at + step * along) - bend.point(at - step * along)) / (2.0 * step);
}

TEST(Bend, HasTheSagittasThatItIsToldAndKeepsTheCorners) {
  EXPECT_EQ(windscreen.point({700, 400, 0}), (vec3{700, 400, 40}));
  EXPECT_EQ(windscreen.point({0, 0, 0}), (vec3{0, 0, 0}));
  EXPECT_EQ(windscreen.point({1400, 800, 0}), (vec3{1400, 800, 0}));
  // The middle of a side along y is off the corners by the sagitta along y alone.
  EXPECT_EQ(windscreen.point({0, 400, 0}), (vec3{0, 400, -20}));
  EXPECT_EQ(windscreen.point({700, 0, 0}), (vec3{700, 0, 60}));
  EXPECT_EQ(Bend{}.point({1.2345678, 2, 3}), (vec3{1.2345678, 2, 3}));
}

TEST(Bend, KeepsTheThicknessAlongTheNormal) {
  for (double x = 0.0; x <= 1400.0; x += 87.5) {
    for (double y = 0.0; y <= 800.0; y += 50.0) {
      const vec3 through = windscreen.point({x, y, 3}) - windscreen.point({x, y, -3});
      EXPECT_NEAR(glm::length(through), 6.0, 3e-5);
      EXPECT_NEAR(glm::dot(through / 6.0, windscreen.normal({x, y, 3}, {0, 0, 1})), 1.0, 1e-5);
    }
  }
}

TEST(Bend, NormalsAreThoseOfTheBentSurface) {
  const std::array<vec3, 4> normals = {vec3{0, 0, 1}, vec3{1, 0, 0}, vec3{0, -1, 0}, vec3{0.48, 0.6, 0.64}};
  for (const vec3 at : {vec3{100, 50, 3}, vec3{1390, 700, -3}, vec3{650, 30, 0}}) {
    for (const vec3 normal : normals) {
      // Two ways within the flat facet, where they are carried.
      const vec3 one = glm::normalize(glm::cross(normal, vec3{0.3, -0.7, 0.2}));
      const vec3 other = glm::cross(normal, one);
      const vec3 across = glm::normalize(glm::cross(carried(windscreen, at, one), carried(windscreen, at, other)));
      const vec3 bent = windscreen.normal(at, normal);
      EXPECT_NEAR(glm::length(bent), 1.0, 1e-12);
      EXPECT_LT(glm::length(bent - across), 2e-4) << at.x << " " << normal.x;
      // What is not bent is off by more.
      if (at.x != 650.0) {
        EXPECT_GT(glm::length(normal - across), 2e-3);
      }
    }
  }
}

using Corners = std::array<std::uint32_t, 3>;

// A box of 1400 × 800 × 6 mm about the middle plane.
const std::vector<vec3> box = {{0, 0, -3}, {1400, 0, -3}, {1400, 800, -3}, {0, 800, -3},
                               {0, 0, 3},  {1400, 0, 3},  {1400, 800, 3},  {0, 800, 3}};
const std::vector<Corners> box_sides = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                                        {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};

std::vector<vec3> with_added(std::vector<vec3> points, const Refinement& parts) {
  for (const auto [a, b] : parts.added) points.push_back(0.5 * (points[a] + points[b]));
  return points;
}

// How far the bent triangles are off the bent surface: at places within each, by where these should be.
double farthest_off(const std::vector<vec3>& points, const Refinement& parts) {
  double most = 0.0;
  for (const Corners& c : parts.triangles) {
    for (const vec3 share :
         {vec3{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}, vec3{0.5, 0.5, 0.0}, vec3{0.0, 0.5, 0.5}, vec3{0.5, 0.0, 0.5}}) {
      vec3 flat{0, 0, 0};
      vec3 bent{0, 0, 0};
      for (std::size_t k = 0; k < 3; ++k) {
        flat += share[k] * points[c[k]];
        bent += share[k] * windscreen.point(points[c[k]]);
      }
      most = std::max(most, glm::length(windscreen.point(flat) - bent));
    }
  }
  return most;
}

TEST(Refinement, FollowsTheBendWithinItsBound) {
  for (const double bound : {1.0, 0.02}) {
    const Refinement parts = refinement(box, box_sides, windscreen, bound);
    const std::vector<vec3> points = with_added(box, parts);
    const double off = farthest_off(points, parts);
    EXPECT_LE(off, bound);
    EXPECT_GT(off, 0.1 * bound);  // and is no finer than it needs
  }
  EXPECT_GT(farthest_off(box, refinement(box, box_sides, {}, 1.0)), 10.0);  // a twin that is not cut
}

TEST(Refinement, StaysClosedAndTurned) {
  const Refinement parts = refinement(box, box_sides, windscreen, 0.1);
  const std::vector<vec3> points = with_added(box, parts);
  ASSERT_EQ(parts.triangles.size(), parts.part_of.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double flat_volume = 0.0;
  for (std::size_t i = 0; i < parts.triangles.size(); ++i) {
    const Corners& c = parts.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) ++edges[{c[k], c[(k + 1) % 3]}];
    flat_volume += glm::dot(points[c[0]], glm::cross(points[c[1]], points[c[2]])) / 6.0;
    const Corners& whole = box_sides[parts.part_of[i]];
    const auto across = [&](const Corners& of) {
      return glm::cross(points[of[1]] - points[of[0]], points[of[2]] - points[of[0]]);
    };
    EXPECT_GT(glm::dot(across(c), across(whole)), 0.0);
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
  EXPECT_NEAR(flat_volume, 1400.0 * 800.0 * 6.0, 1e-4);
}

TEST(Refinement, OfSurfacesThatShareAnEdgeSharesItsPoints) {
  const std::vector<vec3> one = {{0, 0, 3}, {1300, 700, 3}, {20, 790, 3}};
  const std::vector<vec3> other = {{1300, 700, 3}, {0, 0, 3}, {1399, 1, 3}};
  const std::vector<Corners> triangle = {{0, 1, 2}};
  const auto on_edge = [&](const std::vector<vec3>& corners) {
    std::vector<std::array<double, 3>> places;
    for (const vec3& p : with_added(corners, refinement(corners, triangle, windscreen, 0.05))) {
      const vec3 bent = windscreen.point(p);
      if (std::abs(p.x * 700.0 - p.y * 1300.0) < 1e-6) places.push_back({bent.x, bent.y, bent.z});
    }
    std::ranges::sort(places);
    return places;
  };
  EXPECT_GT(on_edge(one).size(), 10U);
  EXPECT_EQ(on_edge(one), on_edge(other));
}

TEST(Refinement, LeavesFlatPlatesAlone) {
  const Refinement parts = refinement(box, box_sides, {}, 0.01);
  EXPECT_TRUE(parts.added.empty());
  EXPECT_EQ(parts.triangles, box_sides);
}

}  // namespace
}  // namespace shatterpave::geometry
