#include "glass/map/crack_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/random.h"
#include "geometry/predicates.h"
#include "glass/network_oracle.h"

namespace shatterpave::glass {
namespace {

using geometry::LatticePoint;

const geometry::Polygon square_pane_mm = {{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}};

int started(CrackMap& map, LatticePoint at) { return map.start(map.add_hub(at), CrackKind::large, 0, CrackEnd::At::impact); }

TEST(CrackMap, GoesOnWhereNothingIsInTheWay) {
  CrackMap map(square_pane_mm, 1.0);
  const int crack = started(map, {5000, 5000});
  EXPECT_FALSE(map.extend(crack, {7000, 6000}).has_value());
  EXPECT_EQ(map.tip(crack), (LatticePoint{7000, 6000}));
  EXPECT_TRUE(map.is_growing(crack));
}

TEST(CrackMap, EndsOnTheEdge) {
  CrackMap map(square_pane_mm, 1.0);
  const int crack = started(map, {5000, 5000});
  const auto arrest = map.extend(crack, {15000, 8000});
  ASSERT_TRUE(arrest.has_value());
  EXPECT_EQ(arrest->end.at, CrackEnd::At::edge);
  EXPECT_EQ(map.tip(crack), (LatticePoint{10000, 6500}));
  EXPECT_FALSE(map.is_growing(crack));
}

TEST(CrackMap, EndsOnASlantedEdgeWithinAMicrometreAndNotOutside) {
  const geometry::Polygon triangle = {{0.0, 0.0}, {9.973, 0.0}, {0.0, 7.127}};
  for (std::uint32_t i = 0; i < 200; ++i) {
    CrackMap map(triangle, 1.0);
    const int crack = started(map, {1500 + 3 * i, 1500 + i});
    const auto arrest = map.extend(crack, {9000 - 37 * i, 6000 + 11 * i});
    ASSERT_TRUE(arrest.has_value());
    EXPECT_EQ(arrest->end.at, CrackEnd::At::edge);
    EXPECT_EQ(faults({{{geometry::to_mm(map.points(crack).front())}}, map.cracks()}, triangle), std::vector<std::string>{});
  }
}

TEST(CrackMap, EndsInAVertexThatTheOtherCrackGets) {
  CrackMap map(square_pane_mm, 1.0);
  const int first = started(map, {1000, 1000});
  map.extend(first, {8000, 4000});
  const int second = started(map, {5000, 1000});
  const auto arrest = map.extend(second, {4000, 9000});
  ASSERT_TRUE(arrest.has_value());
  EXPECT_EQ(arrest->end, (CrackEnd{CrackEnd::At::crack, first}));
  EXPECT_TRUE(arrest->closed_region.empty());
  ASSERT_EQ(map.points(first).size(), 3U);
  EXPECT_EQ(map.points(first)[1], map.tip(second));
  EXPECT_TRUE(map.is_growing(first));
}

TEST(CrackMap, StopsACrackWhoseTipIsMet) {
  CrackMap map(square_pane_mm, 1.0);
  const int first = started(map, {1000, 1000});
  map.extend(first, {5000, 5000});
  const int second = started(map, {9000, 5000});
  EXPECT_TRUE(map.extend(second, {4000, 5000}).has_value());
  EXPECT_EQ(map.tip(second), (LatticePoint{5000, 5000}));
  EXPECT_FALSE(map.is_growing(first));
  EXPECT_EQ(map.cracks()[0].end, (CrackEnd{CrackEnd::At::crack, second}));
}

// A triangle of two radials and a ring crack between them: closed when the ring's second arm ends.
TEST(CrackMap, TellsTheRegionThatTheLastCrackCloses) {
  CrackMap map(square_pane_mm, 1.0);
  const CrackMap::Hub impact = map.add_hub({1000, 1000});
  const int right = map.start(impact, CrackKind::large, 0, CrackEnd::At::impact);
  const int up = map.start(impact, CrackKind::large, 0, CrackEnd::At::impact);
  map.extend(right, {9000, 1000});
  map.extend(up, {1000, 9000});
  const CrackMap::Hub ring = map.add_hub({3000, 3000});
  const int one = map.start(ring, CrackKind::circular, 0, CrackEnd::At::ring);
  const int other = map.start(ring, CrackKind::circular, 0, CrackEnd::At::ring);
  const auto first = map.extend(one, {5000, 0});
  ASSERT_TRUE(first.has_value());
  EXPECT_TRUE(first->closed_region.empty());
  const auto second = map.extend(other, {0, 5000});
  ASSERT_TRUE(second.has_value());
  ASSERT_FALSE(second->closed_region.empty());
  geometry::Polygon region;
  for (const LatticePoint p : second->closed_region) region.push_back(geometry::to_mm(p));
  EXPECT_TRUE(geometry::contains(region, {2.0, 2.0}));
  EXPECT_FALSE(geometry::contains(region, {4.0, 4.0}));
  EXPECT_NEAR(std::abs(geometry::area(region)), 0.5 * (10.0 / 3.0 * 2.0 + 10.0 / 3.0 * 2.0), 0.01);
}

// The edge is no crack, but two cracks that end in one point of it surround what lies between them.
TEST(CrackMap, CracksThatEndInOnePointOfTheEdgeCloseARegion) {
  CrackMap map(square_pane_mm, 1.0);
  const CrackMap::Hub impact = map.add_hub({5000, 5000});
  const int straight = map.start(impact, CrackKind::large, 0, CrackEnd::At::impact);
  const int bent = map.start(impact, CrackKind::large, 0, CrackEnd::At::impact);
  EXPECT_TRUE(map.extend(straight, {15000, 9000})->closed_region.empty());
  EXPECT_FALSE(map.extend(bent, {8000, 5000}).has_value());
  const auto arrest = map.extend(bent, {12000, 9000});
  ASSERT_TRUE(arrest.has_value());
  EXPECT_EQ(arrest->end.at, CrackEnd::At::edge);
  EXPECT_EQ(map.tip(bent), map.tip(straight));
  geometry::Polygon region;
  for (const LatticePoint p : arrest->closed_region) region.push_back(geometry::to_mm(p));
  ASSERT_GE(region.size(), 3U);
  EXPECT_TRUE(geometry::contains(region, {8.0, 5.5}));
  EXPECT_FALSE(geometry::contains(region, {9.5, 6.0}));
}

TEST(CrackMap, AnImpactOnACrackBecomesAVertexOfIt) {
  CrackMap map(square_pane_mm, 1.0);
  const int first = started(map, {1000, 1000});
  map.extend(first, {9000, 5000});
  EXPECT_TRUE(map.is_taken({5000, 3000}));
  EXPECT_FALSE(map.is_taken({5000, 3001}));
  const int second = started(map, {5000, 3000});
  EXPECT_EQ(map.points(first).size(), 3U);
  EXPECT_FALSE(map.extend(second, {5000, 9000}).has_value());
}

TEST(CrackMap, EndsOpenWhereItTurnsBackOverItself) {
  CrackMap map(square_pane_mm, 1.0);
  const int crack = started(map, {5000, 5000});
  map.extend(crack, {7000, 5000});
  const auto arrest = map.extend(crack, {4000, 5000});
  ASSERT_TRUE(arrest.has_value());
  EXPECT_EQ(arrest->end, (CrackEnd{CrackEnd::At::open, {}}));
  EXPECT_EQ(map.tip(crack), (LatticePoint{7000, 5000}));
}

TEST(CrackMap, LeadsNoCrackThroughAVertexOfAnother) {
  CrackMap map(square_pane_mm, 1.0);
  const int met = started(map, {1000, 1000});
  map.extend(met, {2000, 1017});  // at x = 1.1 mm it is 0.3 µm below the lowest vertex of the next
  const int hanging = started(map, {1050, 1900});
  map.extend(hanging, {1100, 1002});
  map.extend(hanging, {1150, 1900});
  const int arriving = started(map, {1100, 500});
  ASSERT_TRUE(map.extend(arriving, {1100, 1500}).has_value());
  const std::vector<ImpactCounts> impacts = {{{1.0, 1.0}}, {{1.05, 1.9}}, {{1.1, 0.5}}};
  std::vector<Crack> cracks = map.cracks();
  for (Crack& crack : cracks) crack.impact = crack.id;
  EXPECT_EQ(faults({impacts, cracks}, square_pane_mm), std::vector<std::string>{});
}

TEST(CrackMap, LeadsNoCrackAlongTheEdgeAndOn) {
  CrackMap map(square_pane_mm, 1.0);
  const int met = started(map, {1, 5000});  // 1 µm beside the edge
  map.extend(met, {1, 6000});
  map.extend(met, {0, 7000});
  const int arriving = started(map, {3000, 6600});
  ASSERT_TRUE(map.extend(arriving, {-3000, 6600}).has_value());
  std::vector<Crack> cracks = map.cracks();
  for (Crack& crack : cracks) crack.impact = crack.id;
  EXPECT_EQ(faults({{{{0.001, 5.0}}, {{3.0, 6.6}}}, cracks}, square_pane_mm), std::vector<std::string>{});
}

// Sixty cracks from 1 µm beside a corner that points inwards, where they crowd one another off the few points of the lattice.
TEST(CrackMap, StaysInsideAtCornersThatPointInwards) {
  const geometry::Polygon notched = {{0, 0},        {1.741, 0},    {1.741, 0.212}, {1.239, 0.187},
                                     {1.239, 0.02}, {0.87, 0.022}, {0.87, 0.132}};
  const geometry::Polygon slanted = {{-2.0, -2.0}, {2.0, -2.0}, {2.0, 2.0}, {0.0, 0.0}, {-0.1, 2.0}, {-2.0, 2.0}};
  for (const auto& [outline, from] : {std::pair{notched, LatticePoint{1238, 19}}, std::pair{slanted, LatticePoint{1, -1}},
                                      std::pair{slanted, LatticePoint{-1, 0}}}) {
    for (std::uint64_t run = 0; run < 60; ++run) {
      CrackMap map(outline, 1.0);
      const CrackMap::Hub hub = map.add_hub(from);
      for (std::uint32_t i = 0; i < 60; ++i) {
        const int crack = map.start(hub, CrackKind::large, 0, CrackEnd::At::impact);
        for (std::uint32_t step = 0; step < 4 && map.is_growing(crack); ++step) {
          const double turn = uniform(run, {Stream::turn, Id("corner").child(i), step});
          const vec2 way = 4.0 * Angle::radians(2.0 * pi * (step == 0 ? turn : 0.1 * turn + i / 60.0)).direction();
          const LatticePoint tip = map.tip(crack);
          map.extend(crack, {tip.x + std::llround(way.x), tip.y + std::llround(way.y)});
        }
        if (map.is_growing(crack)) map.stop(crack, CrackEnd::At::open);
      }
      EXPECT_EQ(faults({{{geometry::to_mm(from)}}, map.cracks()}, outline), std::vector<std::string>{}) << run;
    }
  }
}

// Many cracks in very little room, where the lattice is coarse against what happens: 1,000 short steps within 0.06 mm.
TEST(CrackMap, StaysSoundWhereTheLatticeIsCoarse) {
  const geometry::Polygon tiny = {{0.0, 0.0}, {0.06, 0.0}, {0.055, 0.06}, {0.0, 0.05}};
  int ended_on_cracks = 0;
  for (std::uint64_t run = 0; run < 400; ++run) {
    CrackMap map(tiny, 0.01);
    const auto draw = [&](std::uint32_t i, double low, double high) {
      return static_cast<std::int64_t>(low + (high - low) * uniform(run, {Stream::turn, Id("tiny"), i}));
    };
    std::vector<ImpactCounts> impacts;
    for (std::uint32_t i = 0; i < 25; ++i) {
      const LatticePoint at{draw(4 * i, 5.0, 50.0), draw(4 * i + 1, 5.0, 45.0)};
      if (map.is_taken(at)) continue;
      const int crack = map.start(map.add_hub(at), CrackKind::large, static_cast<int>(impacts.size()), CrackEnd::At::impact);
      impacts.push_back({geometry::to_mm(at), 1, 1, 0});
      for (std::uint32_t step = 0; step < 40 && map.is_growing(crack); ++step) {
        const LatticePoint tip = map.tip(crack);
        const auto arrest =
            map.extend(crack, {tip.x + draw(1000 + 100 * i + step, -4.0, 9.0), tip.y + draw(4 * i + 2, -6.0, 7.0)});
        if (arrest && arrest->end.at == CrackEnd::At::crack) ++ended_on_cracks;
      }
      if (map.is_growing(crack)) map.stop(crack, CrackEnd::At::open);
    }
    EXPECT_EQ(faults({impacts, map.cracks()}, tiny), std::vector<std::string>{}) << "run " << run;
  }
  EXPECT_GT(ended_on_cracks, 2000);
}

}  // namespace
}  // namespace shatterpave::glass
