// The hole that shards leave: one, of arcs and cusps, as large as energy and pane have it.
#include "glass/shards/hole_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

#include "core/angle.h"
#include "geometry/clip.h"
#include "geometry/segment_distance.h"
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

// Where the outline, counter-clockwise, points inwards.
struct Cusp {
  std::size_t at = 0;      // vertex
  double glass_deg = 0.0;  // angle of the glass there
  vec2 out{0.0, 0.0};      // from its tip along its middle
};

std::vector<Cusp> cusps_of(const geometry::Polygon& outline) {
  std::vector<Cusp> cusps;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const vec2 in = glm::normalize(outline[i] - outline[(i + n - 1) % n]);
    const vec2 out = glm::normalize(outline[(i + 1) % n] - outline[i]);
    const Angle turn = (Angle::of(out) - Angle::of(in)).wrapped();
    if (turn < Angle::degrees(-30.0)) cusps.push_back({i, 180.0 + turn.degrees(), glm::normalize(out - in)});
  }
  return cusps;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// Of many outlines.
struct Irregularity {
  std::vector<double> width_spread;  // SD over mean of the angles between neighbouring cusps of an outline, one an outline
  std::vector<double> depths;        // of cusps, as shares of the width of the hole
  std::vector<double> leans;         // of cusps, off the way from the impact, degrees

  double widths() const { return mean(width_spread); }
  double lean_deg() const { return mean(leans); }
  double share_below(double depth) const {
    return static_cast<double>(std::ranges::count_if(depths, [&](double one) { return one < depth; })) /
           static_cast<double>(depths.size());
  }
  double deep_share() const {
    const auto count = std::ranges::count_if(depths, [](double depth) { return depth >= 0.05 && depth <= 0.2; });
    return static_cast<double>(count) / static_cast<double>(depths.size());
  }
};

std::ostream& operator<<(std::ostream& stream, const Irregularity& all) {
  return stream << "widths " << all.widths() << ", cusps of 5 to 20 % " << all.deep_share() << " (" << all.share_below(0.05)
                << " below), lean " << all.lean_deg();
}

bool is_like_photographs(const Irregularity& all) {
  return all.widths() > 0.3 && all.deep_share() > 0.6 && all.lean_deg() > 15.0;
}

// How far the tip lies within the line between the outermost points of the arcs beside it.
double depth_of(const geometry::Polygon& outline, vec2 centre, std::size_t before, std::size_t tip, std::size_t behind) {
  const std::size_t n = outline.size();
  const auto outermost = [&](std::size_t from, std::size_t to) {
    vec2 farthest = outline[from];
    for (std::size_t i = from; i != to; i = (i + 1) % n) {
      if (glm::length(outline[i] - centre) > glm::length(farthest - centre)) farthest = outline[i];
    }
    return farthest;
  };
  const vec2 a = outermost(before, tip);
  const vec2 along = glm::normalize(outermost((tip + 1) % n, behind) - a);
  return along.x * (outline[tip] - a).y - along.y * (outline[tip] - a).x;
}

void add(const geometry::Polygon& outline, vec2 centre, Irregularity& all) {
  const std::vector<Cusp> cusps = cusps_of(outline);
  const std::size_t n = cusps.size();
  const double width_mm = 2.0 * std::sqrt(std::abs(geometry::area(outline)) / pi);
  std::vector<double> widths;
  double squares = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const auto direction = [&](std::size_t cusp) { return Angle::of(outline[cusps[cusp % n].at] - centre); };
    const double width = (direction(k + 1) - direction(k)).wrapped().degrees();
    widths.push_back(width < 0.0 ? width + 360.0 : width);
    all.leans.push_back(std::abs((Angle::of(cusps[k].out) - direction(k)).wrapped().degrees()));
    all.depths.push_back(depth_of(outline, centre, cusps[(k + n - 1) % n].at, cusps[k].at, cusps[(k + 1) % n].at) / width_mm);
  }
  for (const double width : widths) squares += (width - mean(widths)) * (width - mean(widths));
  all.width_spread.push_back(std::sqrt(squares / static_cast<double>(n)) / mean(widths));
}

// The length of the outline that lies on cracks of the network, to a thousandth of a millimetre.
double along_cracks_mm(const geometry::Polygon& outline, const CrackNetwork& network) {
  const auto is_on = [&](vec2 p) {
    return std::ranges::any_of(network.cracks, [&](const Crack& crack) {
      for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
        if (geometry::distance_to_segment(p, crack.points_mm[i - 1], crack.points_mm[i]) < 0.002) return true;
      }
      return false;
    });
  };
  double length_mm = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const vec2 a = outline[i];
    const vec2 b = outline[(i + 1) % outline.size()];
    if (is_on(a) && is_on(b) && is_on(0.5 * (a + b))) length_mm += glm::length(b - a);
  }
  return length_mm;
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
    const std::vector<Cusp> cusps = cusps_of(hole.front().outline);
    fewest = std::min(fewest, cusps.size());
    most = std::max(most, cusps.size());
    for (const Cusp& cusp : cusps) {
      EXPECT_GE(cusp.glass_deg, 19.9) << seed;
      EXPECT_LE(cusp.glass_deg, 60.1) << seed;
    }
  }
  EXPECT_GE(fewest, 6U);
  EXPECT_LE(most, 12U);
  EXPECT_GT(most, fewest + 2);
  // A star of blunt corners is found out.
  const std::vector<Cusp> blunt = cusps_of({{0.0, 0.0}, {30.0, 20.0}, {60.0, 0.0}, {40.0, 30.0}, {60.0, 60.0}, {0.0, 60.0}});
  ASSERT_EQ(blunt.size(), 2U);
  EXPECT_GT(std::max(blunt[0].glass_deg, blunt[1].glass_deg), 60.1);
}

// A drawn cloud: even arcs with cusps of 40° that point to the centre.
geometry::Polygon cloud(int count) {
  geometry::Polygon outline;
  constexpr int pieces = 24;
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < pieces; ++i) {
      const double share = static_cast<double>(i) / pieces;
      const double bulge = 1.0 + 0.3 * std::sqrt(4.0 * share * (1.0 - share));
      outline.push_back(50.0 * bulge * Angle::radians(2.0 * pi * (k + share) / count).direction());
    }
  }
  return outline;
}

// What is not seen in one cusp alone: how arcs differ in width, how far cusps reach in, how they lean.
TEST(HoleOutline, IsNoDrawnCloud) {
  const Pane pane = hit_window();
  Irregularity real;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    add(hole_outlines(pane, broken(pane, seed), seed).front().outline, pane.impacts[0].at_mm, real);
  }
  EXPECT_TRUE(is_like_photographs(real)) << real;
  Irregularity drawn;
  for (int count = 6; count <= 12; ++count) add(cloud(count), {0.0, 0.0}, drawn);
  EXPECT_LT(drawn.widths(), 0.05);
  EXPECT_LT(drawn.lean_deg(), 5.0);
  EXPECT_FALSE(is_like_photographs(drawn)) << drawn;
}

// Where a radial is near, a piece beside it has left along it: part of the outline is crack, and no splinter is left beside it.
TEST(HoleOutline, RunsAlongRadialsInPart) {
  const Pane pane = hit_window();
  double along_mm = 0.0;
  int outlines = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const CrackNetwork network = broken(pane, seed);
    const double one_mm = along_cracks_mm(hole_outlines(pane, network, seed).front().outline, network);
    along_mm += one_mm;
    outlines += one_mm > 2.0 ? 1 : 0;
    // Turned by a degree about the impact it runs along none.
    geometry::Polygon turned = hole_outlines(pane, network, seed).front().outline;
    for (vec2& p : turned) p = pane.impacts[0].at_mm + rotated(p - pane.impacts[0].at_mm, Angle::degrees(1.0));
    EXPECT_LT(along_cracks_mm(turned, network), 0.5) << seed;
  }
  EXPECT_GT(outlines, 40);
  EXPECT_GT(along_mm, 60 * 8.0);
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
