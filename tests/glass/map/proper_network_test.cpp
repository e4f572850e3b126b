#include "glass/map/proper_network.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/error.h"
#include "core/random.h"
#include "glass/shards/shard_faces.h"
#include "measure/crossings.h"

namespace shatterpave::glass {
namespace {

const geometry::Polygon square = {{0.0, 0.0}, {100.0, 0.0}, {100.0, 100.0}, {0.0, 100.0}};
const ImpactCounts middle{{50.0, 50.0}, 0, 0, 0, {}};

TEST(ProperNetwork, CutsTheLaterOfTwoThatCross) {
  const CrackNetwork network = proper_network({{CrackKind::circular, 0, true, {{60.0, 40.0}, {60.0, 60.0}}},
                                               {CrackKind::radial, 0, true, {{50.0, 50.0}, {80.0, 50.0}}}},
                                              square, {middle}, 0.0);
  ASSERT_EQ(network.cracks.size(), 3U);
  EXPECT_EQ(network.cracks[0].kind, CrackKind::radial);
  EXPECT_EQ(network.cracks[0].points_mm, (std::vector<vec2>{{50.0, 50.0}, {60.0, 50.0}, {80.0, 50.0}}));
  EXPECT_EQ(network.cracks[0].start.at, CrackEnd::At::impact);
  EXPECT_EQ(network.cracks[1].end, (CrackEnd{CrackEnd::At::crack, 0}));
  EXPECT_EQ(network.cracks[2].start, (CrackEnd{CrackEnd::At::crack, 0}));
  EXPECT_TRUE(measure::crossings(network).empty());
}

TEST(ProperNetwork, CutsOffWhatLiesOutsideAndEndsOnTheEdge) {
  const CrackNetwork network =
      proper_network({{CrackKind::radial, 0, true, {{130.0, 50.0}, {50.0, 50.0}}}}, square, {middle}, 0.0);
  ASSERT_EQ(network.cracks.size(), 1U);
  EXPECT_EQ(network.cracks[0].points_mm, (std::vector<vec2>{{50.0, 50.0}, {100.0, 50.0}}));
  EXPECT_EQ(network.cracks[0].end.at, CrackEnd::At::edge);
}

TEST(ProperNetwork, MovesEndsThatNearlyMeet) {
  const std::vector<DrawnCrack> lines = {{CrackKind::radial, 0, true, {{50.0, 50.0}, {50.0, 99.99}}},
                                         {CrackKind::circular, 0, true, {{50.015, 70.0}, {90.0, 70.0}}}};
  const CrackNetwork snapped = proper_network(lines, square, {middle}, 0.02);
  EXPECT_EQ(snapped.cracks[0].end.at, CrackEnd::At::edge);
  EXPECT_EQ(snapped.cracks[1].start, (CrackEnd{CrackEnd::At::crack, 0}));
  const CrackNetwork as_given = proper_network(lines, square, {middle}, 0.001);
  EXPECT_EQ(as_given.cracks[0].end.at, CrackEnd::At::open);
  EXPECT_EQ(as_given.cracks[1].start.at, CrackEnd::At::origin);
}

TEST(ProperNetwork, RefusesNothingWithinThePane) {
  EXPECT_THROW(proper_network({{CrackKind::radial, 0, true, {{200.0, 50.0}, {300.0, 50.0}}}}, square, {middle}, 0.0),
               InputError);
}

// Whatever lines do: no two cross, and their pieces tile the pane.
TEST(ProperNetwork, MakesProperNetworksOfAnyLines) {
  Pane pane;
  pane.outline_mm = square;
  int cut = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::uint32_t draw = 0;
    // On a coarse grid for every second seed, so that lines overlap, touch and pass through each other's ends.
    const auto coordinate = [&] {
      const double u = uniform(seed, {Stream::ground, Id("lines"), draw++});
      return seed % 2 == 0 ? std::floor(12.0 * u) * 10.0 - 10.0 : 120.0 * u - 10.0;
    };
    std::vector<DrawnCrack> lines;
    for (int i = 0; i < 25; ++i) {
      DrawnCrack line{i % 3 == 0 ? CrackKind::circular : CrackKind::radial, 0, true, {}};
      for (int k = 0; k < 5; ++k) {
        const double x = coordinate();
        line.points_mm.push_back({x, coordinate()});
      }
      lines.push_back(line);
    }
    const CrackNetwork network = proper_network(lines, square, {middle}, 0.01);
    EXPECT_TRUE(measure::crossings(network).empty()) << seed;
    cut += network.cracks.size() > lines.size() ? 1 : 0;
    double area = 0.0;
    for (const ShardFace& face : faced_pane(pane, network).faces) area += geometry::area(region(face.face));
    EXPECT_NEAR(area, 10'000.0, 0.1) << seed;
  }
  EXPECT_EQ(cut, 40);
}

}  // namespace
}  // namespace shatterpave::glass
