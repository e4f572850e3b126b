#include "export/shapes/tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "export/export_panes.h"
#include "geometry/polygon.h"
#include "glass/breaking.h"

namespace shatterpave::exporting::shapes {
namespace {

using support::broken_pane;
using support::network_of;
using support::pane_with;

// What rounding to the lattice may take of the clearance.
constexpr double clearance_mm = tube_clearance_mm - 0.002;

double distance(vec2 point, vec2 a, vec2 b) {
  const double length2 = glm::dot(b - a, b - a);
  const double t = length2 == 0.0 ? 0.0 : std::clamp(glm::dot(point - a, b - a) / length2, 0.0, 1.0);
  return glm::length(point - a - t * (b - a));
}

bool cross_each_other(vec2 a, vec2 b, vec2 c, vec2 d) {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0.0 && cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
}

double distance(vec2 a, vec2 b, vec2 c, vec2 d) {
  if (cross_each_other(a, b, c, d)) return 0.0;
  return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

// Whether the flat-ended tubes lie on two sides of a line, as their rectangles in the plane: the axes are coplanar, so
// cylinders meet just where their rectangles do.
bool rectangles_apart(const Tube& s, const Tube& t) {
  const auto separates = [](vec2 normal, const Tube& p, const Tube& q) {
    const auto range = [&](const Tube& tube) {
      const vec2 along = glm::normalize(tube.b_mm - tube.a_mm);
      const double half = tube.radius_mm * std::abs(glm::dot(left_of(along), normal));
      const double a = glm::dot(tube.a_mm, normal);
      const double b = glm::dot(tube.b_mm, normal);
      return std::pair{std::min(a, b) - half, std::max(a, b) + half};
    };
    return range(p).second < range(q).first || range(q).second < range(p).first;
  };
  const vec2 u = glm::normalize(s.b_mm - s.a_mm);
  const vec2 v = glm::normalize(t.b_mm - t.a_mm);
  return separates(u, s, t) || separates(left_of(u), s, t) || separates(v, s, t) || separates(left_of(v), s, t);
}

// All pairs, by brute force.
int touching_pairs(const std::vector<Tube>& tubes) {
  int touching = 0;
  for (std::size_t i = 0; i < tubes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double apart = distance(tubes[i].a_mm, tubes[i].b_mm, tubes[j].a_mm, tubes[j].b_mm);
      if (apart > tubes[i].radius_mm + tubes[j].radius_mm + clearance_mm) continue;
      if (tubes[i].crack == tubes[j].crack && rectangles_apart(tubes[i], tubes[j])) continue;
      ++touching;
    }
  }
  return touching;
}

void expect_within(const BrokenPane& broken, const TubedCracks& cracks) {
  const geometry::Polygon& outline = broken.pane.outline_mm;
  const auto to_outline = [&](vec2 a, vec2 b) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      nearest = std::min(nearest, distance(a, b, outline[i], outline[(i + 1) % outline.size()]));
    }
    return nearest;
  };
  for (const Tube& tube : cracks.tubes) {
    EXPECT_GT(to_outline(tube.a_mm, tube.b_mm), tube.radius_mm + clearance_mm);
    EXPECT_TRUE(geometry::contains(outline, tube.a_mm));
    EXPECT_LT(2.0 * tube.radius_mm, broken.pane.thickness_mm);
    for (const glass::ImpactZone& zone : cracks.zones) {
      EXPECT_GT(distance(zone.centre_mm, tube.a_mm, tube.b_mm), zone.radius_mm + tube.radius_mm + clearance_mm);
    }
  }
  for (std::size_t i = 0; i < cracks.zones.size(); ++i) {
    EXPECT_GT(to_outline(cracks.zones[i].centre_mm, cracks.zones[i].centre_mm), cracks.zones[i].radius_mm);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT(glm::length(cracks.zones[i].centre_mm - cracks.zones[j].centre_mm),
                cracks.zones[i].radius_mm + cracks.zones[j].radius_mm);
    }
  }
}

class Tubes : public testing::TestWithParam<int> {};

TEST_P(Tubes, NoTwoTouchAndAllLieWithin) {
  const BrokenPane broken = broken_pane(pane_with(GetParam()));
  const TubedCracks cracks = tubed_cracks(broken.pane, broken.network);
  EXPECT_EQ(touching_pairs(cracks.tubes), 0);
  expect_within(broken, cracks);
}

INSTANTIATE_TEST_SUITE_P(Radials, Tubes, testing::Values(1, 2, 3, 24, 113, 200, 1000));

TEST(TubesOfTwoSheets, LieInTheMiddleOfTheirOwn) {
  glass::Pane pane = pane_with(24);
  pane.glass = glass::Laminated{};
  pane.thickness_mm = 5.0;
  const BrokenPane broken = broken_pane(pane);
  const glass::CrackNetwork far = glass::broken_far_sheet(broken.pane, broken.network, 7);
  const TubedCracks cracks = tubed_cracks(broken.pane, broken.network, far);
  std::array<std::vector<Tube>, 2> of_sheets;
  for (const Tube& tube : cracks.tubes) {
    const bool is_far = tube.crack >= far.cracks.front().id;
    EXPECT_EQ(tube.z_mm, is_far ? -1.44 : 1.44);
    of_sheets.at(is_far ? 1 : 0).push_back(tube);
  }
  for (const std::vector<Tube>& tubes : of_sheets) {
    EXPECT_GT(tubes.size(), 100U);
    EXPECT_EQ(touching_pairs(tubes), 0);
    expect_within(broken, {cracks.zones, tubes});
  }
  EXPECT_GT(touching_pairs(cracks.tubes), 0) << "in one plane they would touch";
}

// The check above finds what it looks for: the same pieces without trimming do touch.
TEST(TubesTwin, UntrimmedCracksTouch) {
  const BrokenPane broken = broken_pane(pane_with(24));
  std::vector<Tube> untrimmed;
  for (const glass::Crack& crack : broken.network.cracks) {
    for (std::size_t i = 0; i + 1 < crack.points_mm.size(); ++i) {
      untrimmed.push_back({crack.points_mm[i], crack.points_mm[i + 1], 0.1, crack.id});
    }
  }
  EXPECT_GT(touching_pairs(untrimmed), 24);
}

TEST(TubesOfPane, HoldsForSeveralImpactsInAnOutlineThatIsNotConvex) {
  glass::Pane pane = pane_with(60);
  pane.outline_mm = {{0, 0}, {300, 0}, {300, 120}, {130, 120}, {130, 300}, {0, 300}};
  pane.impacts.clear();
  for (const vec2 at : {vec2{60, 60}, vec2{75, 66}, vec2{240, 3}, vec2{125.5, 125.25}}) {
    glass::Impact impact;
    impact.at_mm = at;
    impact.radial_count = 60;
    pane.impacts.push_back(impact);
  }
  const BrokenPane broken = broken_pane(pane);
  const TubedCracks cracks = tubed_cracks(broken.pane, broken.network);
  EXPECT_EQ(touching_pairs(cracks.tubes), 0);
  expect_within(broken, cracks);
}

// Hand-made: a crack across the pane, and one that ends on it in the middle. The second is cut back by the sum of the radii and
// the clearance, and so is its start at the edge.
TEST(TubesOfPane, CutsACrackBackWhereItEndsOnAnother) {
  const BrokenPane broken{pane_with(2), network_of({{{0, 100}, {300, 100}}, {{150, 0}, {150, 100}}}, 1), {}};
  const TubedCracks cracks = tubed_cracks(broken.pane, broken.network);
  ASSERT_EQ(cracks.tubes.size(), 2U);
  const double r0 = cracks.tubes[0].radius_mm;
  const double r1 = cracks.tubes[1].radius_mm;
  EXPECT_NEAR(cracks.tubes[0].a_mm.x, r0 + tube_clearance_mm, 0.001);
  EXPECT_NEAR(cracks.tubes[0].b_mm.x, 300 - r0 - tube_clearance_mm, 0.001);
  EXPECT_NEAR(cracks.tubes[1].a_mm.y, r1 + tube_clearance_mm, 0.001);
  EXPECT_NEAR(cracks.tubes[1].b_mm.y, 100 - r0 - r1 - tube_clearance_mm, 0.001);
}

// A last piece that is shorter than tubes are thick would be cut away at its turn: the piece before it goes to the end instead.
TEST(TubesOfPane, NoPieceIsShorterThanATubeIsThick) {
  const std::vector<vec2> points = {{0, 100}, {299.9, 100}, {300, 100.1}};
  const BrokenPane broken{pane_with(2), network_of({points}, -1), {}};
  const TubedCracks cracks = tubed_cracks(broken.pane, broken.network);
  ASSERT_EQ(cracks.tubes.size(), 1U);
  const Tube& tube = cracks.tubes.front();
  ASSERT_LT(glm::length(points[2] - points[1]), 4.0 * tube.radius_mm);
  // It goes straight from the first point to the last.
  for (const vec2 end : {tube.a_mm, tube.b_mm}) EXPECT_NEAR(end.y, 100.0 + end.x / 3000.0, 0.001);
  // Longer pieces all have their tubes.
  const BrokenPane bent{pane_with(2), network_of({{{0, 100}, {2, 101}, {298, 101}, {300, 100}}}, -1), {}};
  EXPECT_EQ(tubed_cracks(bent.pane, bent.network).tubes.size(), 3U);
}

// Nothing much is lost by trimming: what is cut off is a few radii at each end and turn.
TEST(TubesOfPane, KeepsTheLengthOfTheCracks) {
  const BrokenPane broken = broken_pane(pane_with(24));
  const TubedCracks cracks = tubed_cracks(broken.pane, broken.network);
  double of_cracks = 0.0;
  for (const glass::Crack& crack : broken.network.cracks) {
    for (std::size_t i = 0; i + 1 < crack.points_mm.size(); ++i)
      of_cracks += glm::length(crack.points_mm[i + 1] - crack.points_mm[i]);
  }
  double of_tubes = 0.0;
  for (const Tube& tube : cracks.tubes) of_tubes += glm::length(tube.b_mm - tube.a_mm);
  EXPECT_GT(of_tubes, 0.93 * of_cracks);
  EXPECT_LT(of_tubes, of_cracks);
}

// The tubes within joined shards: whole within one each, so far from its border as promised, and none touches another.
class TubesInJoinedShards : public testing::TestWithParam<int> {};

TEST_P(TubesInJoinedShards, LieWithinOneEach) {
  const BrokenPane broken = support::shattered_pane(GetParam(), true);
  std::vector<geometry::Region> bodies;
  for (const glass::Shard& shard : broken.shards) {
    if (!shard.joined.empty()) bodies.push_back(shard.face);
  }
  ASSERT_FALSE(bodies.empty());
  const std::vector<Tube> tubes = tubes_within(broken.pane, broken.network, bodies);
  EXPECT_GT(tubes.size(), 20U);
  EXPECT_EQ(touching_pairs(tubes), 0);
  for (const Tube& tube : tubes) {
    int within = 0;
    for (const geometry::Region& body : bodies) {
      const bool has_start = geometry::contains(body, tube.a_mm);
      EXPECT_EQ(has_start, geometry::contains(body, tube.b_mm));
      if (has_start) ++within;
      const auto expect_clear = [&](const geometry::Polygon& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          EXPECT_GT(distance(tube.a_mm, tube.b_mm, ring[i], ring[(i + 1) % ring.size()]), tube.radius_mm + clearance_mm);
        }
      };
      expect_clear(body.outline);
      std::ranges::for_each(body.holes, expect_clear);
    }
    EXPECT_EQ(within, 1);
    // Bevels are at most 0.3 of the thickness deep.
    EXPECT_LT(tube.radius_mm, 0.2 * broken.pane.thickness_mm);
  }
}

INSTANTIATE_TEST_SUITE_P(Radials, TubesInJoinedShards, testing::Values(24, 60, 113, 200));

// The wrong twin: the tubes of the whole pane leave the bodies.
TEST(TubesInJoinedShardsTwin, ThoseOfTheWholePaneDoNot) {
  const BrokenPane broken = support::shattered_pane(60, true);
  const TubedCracks cracks = tubed_cracks(broken.pane, broken.network);
  const auto is_out = [&](const Tube& tube) {
    return std::ranges::none_of(broken.shards, [&](const glass::Shard& shard) {
      return !shard.joined.empty() && geometry::contains(shard.face, tube.a_mm) && geometry::contains(shard.face, tube.b_mm);
    });
  };
  EXPECT_GT(std::ranges::count_if(cracks.tubes, is_out), 20);
}

}  // namespace
}  // namespace shatterpave::exporting::shapes
