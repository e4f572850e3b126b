// The hole that shards leave: one, of arcs and cusps, as large as energy and pane have it.
#include "glass/shards/hole_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/clip.h"
#include "glass/breaking.h"
#include "glass/shards/shards.h"

namespace shatterpave::glass {
namespace {

Pane hit_window(double size_mm = 300.0) {
  Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0.0, 0.0}, {size_mm, 0.0}, {size_mm, size_mm}, {0.0, size_mm}};
  pane.thickness_mm = 4.0;
  pane.pattern = Pattern::real;
  Impact impact;
  impact.at_mm = {0.5 * size_mm, 0.5 * size_mm};
  impact.radial_count = 40;
  pane.impacts = {impact};
  pane.shards = ShardRules{};
  pane.shards->fallen = 0.0;
  return pane;
}

// Areas of the places within the pane that no standing shard covers, gaps closed.
std::vector<double> holes(const std::vector<Shard>& shards, double gap_mm) {
  std::vector<geometry::Region> grown;
  for (const Shard& shard : shards) {
    if (shard.state != ShardState::standing) continue;
    for (geometry::Region& region : geometry::offset(shard.face, 2.0 * gap_mm)) grown.push_back(std::move(region));
  }
  std::vector<double> areas;
  for (const geometry::Region& region : geometry::united(grown)) {
    for (const geometry::Polygon& hole : region.holes) areas.push_back(-geometry::area(hole));
  }
  std::erase_if(areas, [](double area) { return area < 1.0; });
  return areas;
}

TEST(HoleOutline, ThereIsOneHole) {
  const Pane pane = hit_window();
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::vector<double> areas = holes(shards(pane, broken(pane, seed), seed), pane.shards->gap_mm);
    ASSERT_EQ(areas.size(), 1U) << seed;
    const double radius = hole_radius_mm(pane, pane.impacts[0]);
    EXPECT_NEAR(areas.front(), pi * radius * radius, 0.4 * pi * radius * radius) << seed;
  }
  Pane none = hit_window();
  none.shards->missing = 0.0;
  EXPECT_TRUE(hole_outlines(none, broken(none, 1), 1).empty());
}

TEST(HoleOutline, GoesWithThePaneAndTheEnergy) {
  const Pane pane = hit_window();
  EXPECT_NEAR(hole_radius_mm(hit_window(600.0), hit_window(600.0).impacts[0]), 2.0 * hole_radius_mm(pane, pane.impacts[0]),
              1e-9);
  Impact fast = pane.impacts[0];
  fast.speed_m_s *= 4.0;
  EXPECT_NEAR(hole_radius_mm(pane, fast), 2.0 * hole_radius_mm(pane, pane.impacts[0]), 1e-9);
  Impact shot = pane.impacts[0];
  shot.hole_mm = 12.0;
  EXPECT_EQ(hole_radius_mm(pane, shot), 6.0);
}

// Vertices at which the outline points inwards, with the angle of the glass there.
std::vector<double> cusps_deg(const geometry::Polygon& outline) {
  std::vector<double> angles;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const vec2 in = outline[i] - outline[(i + n - 1) % n];
    const vec2 out = outline[(i + 1) % n] - outline[i];
    const Angle turn = (Angle::of(out) - Angle::of(in)).wrapped();
    if (turn < Angle::degrees(-30.0)) angles.push_back(180.0 + turn.degrees());
  }
  return angles;
}

// All that bends inwards by more than an arc drawn as a polygon is a cusp, as sharp as in photographs.
TEST(HoleOutline, IsOfArcsThatMeetInCusps) {
  const Pane pane = hit_window();
  std::size_t fewest = 100;
  std::size_t most = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const std::vector<geometry::Region> hole = hole_outlines(pane, broken(pane, seed), seed);
    ASSERT_EQ(hole.size(), 1U);
    EXPECT_TRUE(geometry::is_simple(hole.front().outline)) << seed;
    const std::vector<double> angles = cusps_deg(hole.front().outline);
    fewest = std::min(fewest, angles.size());
    most = std::max(most, angles.size());
    for (const double angle : angles) {
      EXPECT_GE(angle, 19.9) << seed;
      EXPECT_LE(angle, 60.1) << seed;
    }
  }
  EXPECT_GE(fewest, 6U);
  EXPECT_LE(most, 12U);
  EXPECT_GT(most, fewest + 2);
  // A star of blunt corners is found out.
  const std::vector<double> blunt = cusps_deg({{0.0, 0.0}, {30.0, 20.0}, {60.0, 0.0}, {40.0, 30.0}, {60.0, 60.0}, {0.0, 60.0}});
  ASSERT_EQ(blunt.size(), 2U);
  EXPECT_GT(std::ranges::max(blunt), 60.1);
}

TEST(HoleOutline, OfAHardHitReachesTheFrameAndLeavesTeeth) {
  Pane pane = hit_window();
  pane.impacts[0].speed_m_s = 60.0;
  int teeth = 0;
  // Of seed 3 two teeth meet above the edge.
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const std::vector<Shard> all = shards(pane, broken(pane, seed), seed);
    EXPECT_TRUE(holes(all, pane.shards->gap_mm).empty()) << seed;
    for (const Shard& shard : all) {
      if (shard.state == ShardState::standing && shard.frame_mm > 0.0 && geometry::area(shard.face) < 300.0) ++teeth;
    }
  }
  EXPECT_GT(teeth, 24);
}

}  // namespace
}  // namespace shatterpave::glass
