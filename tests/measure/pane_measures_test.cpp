#include "measure/pane_measures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "measure/experiment.h"
#include "measure/tracking.h"

namespace shatterpave::measure {
namespace {

using glass::Crack;
using glass::CrackEnd;
using glass::CrackKind;

glass::Pane square_pane() {
  glass::Pane pane;
  pane.outline_mm = {{0.0, 0.0}, {300.0, 0.0}, {300.0, 300.0}, {0.0, 300.0}};
  pane.impacts.resize(1);
  return pane;
}

void add(glass::CrackNetwork& network, CrackKind kind, std::vector<vec2> points, CrackEnd end, int impact = 0) {
  Crack crack;
  crack.id = static_cast<int>(network.cracks.size());
  crack.impact = impact;
  crack.kind = kind;
  crack.points_mm = std::move(points);
  crack.end = end;
  network.cracks.push_back(std::move(crack));
}

// One large crack straight to the edge, one that turns left by 90° on its way, a radial that stops, a ring crack of two arms.
glass::CrackNetwork hand_made() {
  glass::CrackNetwork network;
  network.impacts = {{{150.0, 150.0}, 3, 2, 1}};
  add(network, CrackKind::large, {{150, 150}, {300, 150}}, {CrackEnd::At::edge, {}});
  add(network, CrackKind::large, {{150, 150}, {150, 150 + 5 * chord_mm}, {0, 150 + 5 * chord_mm}}, {CrackEnd::At::edge, {}});
  add(network, CrackKind::radial, {{150, 150}, {150, 100}}, {CrackEnd::At::open, {}});
  add(network, CrackKind::circular, {{180, 120}, {180, 150}}, {CrackEnd::At::crack, 0});
  add(network, CrackKind::circular, {{180, 120}, {180, 110}}, {CrackEnd::At::enclosed, {}});
  return network;
}

TEST(PaneMeasures, OfAHandMadePane) {
  const PaneMeasures pane = measured(hand_made(), square_pane());
  ASSERT_EQ(pane.impacts.size(), 1U);
  const ImpactMeasures& impact = pane.impacts[0];
  EXPECT_EQ(impact.drawn.radial_count, 3);
  EXPECT_EQ(impact.reaching_count, 2);
  EXPECT_EQ(impact.ends, (EndCounts{2, 1, 1, 1}));
  EXPECT_EQ(impact.ring_crack_count, 2);
  EXPECT_EQ(impact.held_ring_end_count, 1);
  EXPECT_EQ(impact.crossing_count, 0);
  // Only large cracks turn: one is straight; the other has 5 chords up, then goes left.
  const auto chords = [](double length) { return static_cast<std::size_t>(length / chord_mm); };
  ASSERT_EQ(impact.turns.size(), chords(150.0) - 1 + 5 + chords(150.0) - 1);
  double sum = 0.0;
  for (const Angle turn : impact.turns) sum += turn.degrees();
  EXPECT_NEAR(sum, 90.0, 1e-9);
  EXPECT_NEAR(impact.turns[chords(150.0) - 1 + 4].degrees(), 90.0, 1e-9);
  // The starting point of the ring crack counts once: 6 chords of 30 mm one way, 2 of 10 mm the other.
  ASSERT_EQ(impact.ring_distances_mm.size(), 1U + 6U + 2U);
  EXPECT_NEAR(impact.ring_distances_mm[0], std::sqrt(1800.0), 1e-12);
  EXPECT_NEAR(impact.ring_distances_mm[1], std::sqrt(900.0 + (30.0 - chord_mm) * (30.0 - chord_mm)), 1e-12);
  EXPECT_NEAR(impact.ring_distances_mm[7], std::sqrt(900.0 + (30.0 + chord_mm) * (30.0 + chord_mm)), 1e-12);
  ASSERT_EQ(impact.edge_angles.size(), 2U);
  EXPECT_NEAR(impact.edge_angles[0].degrees(), 90.0, 1e-12);
  // Right, up and down: gaps of 90°, 90° and 180° about a mean of 120°, so (30² + 30² + 60²) / 3 / 120² = 1/8; at random 2/4.
  ASSERT_TRUE(impact.gap_ratio);
  EXPECT_NEAR(*impact.gap_ratio, 0.25, 1e-9);
}

TEST(PaneMeasures, BelongToTheirImpact) {
  glass::CrackNetwork network = hand_made();
  network.impacts.push_back({{200.0, 60.0}, 1, 1, 0});
  // Through the first impact's crack: a crossing, which the later impact made.
  add(network, CrackKind::large, {{200, 60}, {200, 300}}, {CrackEnd::At::edge, {}}, 1);
  const PaneMeasures pane = measured(network, square_pane());
  ASSERT_EQ(pane.impacts.size(), 2U);
  EXPECT_EQ(pane.impacts[0], measured(hand_made(), square_pane()).impacts[0]);
  EXPECT_EQ(pane.impacts[1].reaching_count, 1);
  EXPECT_EQ(pane.impacts[1].crossing_count, 1);
}

TEST(EdgeAngle, IsOfTheLastChordToTheSideThatItMeets) {
  const geometry::Polygon outline = {{0.0, 0.0}, {100.0, 0.0}, {0.0, 100.0}};
  const auto angle = [&](std::vector<vec2> points) {
    Crack crack;
    crack.points_mm = std::move(points);
    return edge_angle(crack, outline).degrees();
  };
  EXPECT_NEAR(angle({{20.0, 20.0}, {50.0, 50.0}}), 90.0, 1e-9);
  EXPECT_NEAR(angle({{20.0, 20.0}, {20.0, 0.0}}), 90.0, 1e-9);
  EXPECT_NEAR(angle({{20.0, 20.0}, {20.0, 80.0}}), 45.0, 1e-9);
  EXPECT_NEAR(angle({{20.0, 20.0}, {40.0, 0.0}}), 45.0, 1e-9);
  // Bent within the last chord: what counts is from where the crack was a chord away, (30, 0.8 a), to the tip.
  EXPECT_NEAR(angle({{30.0, 40.0}, {30.0, 0.8 * chord_mm}, {30.0 + 0.6 * chord_mm, 0.0}}),
              Angle::radians(std::atan2(0.8, 0.6)).degrees(), 1e-9);
  // Shorter than a chord: from its start.
  EXPECT_NEAR(angle({{30.0, 1.0}, {31.0, 0.0}}), 45.0, 1e-9);
}

TEST(GapRatio, IsNoughtForEvenOneForRandomAndMoreForBundledDirections) {
  std::vector<Angle> even;
  even.reserve(8);
  for (int i = 0; i < 8; ++i) even.push_back(Angle::degrees(45.0 * ((3 * i) % 8) - 180.0));
  EXPECT_NEAR(gap_ratio(even), 0.0, 1e-12);
  // Gaps of 30°, 90° and 240°: about a mean of 120°, (90² + 30² + 120²) / 3 / 120² = 13/24; for 3 at random it is 2/4.
  EXPECT_NEAR(gap_ratio({Angle::degrees(-60.0), Angle::degrees(-30.0), Angle::degrees(60.0)}), 13.0 / 12.0, 1e-12);
  double sum = 0.0;
  double bundled = 0.0;
  constexpr std::uint32_t rounds = 4000;
  for (std::uint32_t round = 0; round < rounds; ++round) {
    std::vector<Angle> random;
    std::vector<Angle> pairs;
    for (std::uint32_t i = 0; i < 12; ++i) {
      random.push_back(Angle::degrees(360.0 * uniform(5, {Stream::turn, Id("gap").child(round), i}) - 180.0));
      pairs.push_back((random[i / 2] + Angle::degrees(i % 2)).wrapped());
    }
    sum += gap_ratio(random);
    bundled += gap_ratio(pairs);
  }
  EXPECT_NEAR(sum / rounds, 1.0, 0.03);
  EXPECT_GT(bundled / rounds, 1.5);
}

TEST(RadialDirections, AreWhereCracksFirstLeaveTheCircle) {
  glass::CrackNetwork network = hand_made();
  std::vector<Angle> directions = radial_directions(network, 0, 60.0);
  ASSERT_EQ(directions.size(), 2U);
  EXPECT_NEAR(directions[0].degrees(), 0.0, 1e-12);
  const double up = 5 * chord_mm;
  EXPECT_NEAR(directions[1].degrees(), Angle::of({-std::sqrt(3600.0 - up * up), up}).degrees(), 1e-9);
  EXPECT_EQ(radial_directions(network, 0, 40.0).size(), 3U);
  EXPECT_DOUBLE_EQ(spread_radius_mm(100), 1.3 * 60.9);
}

// A square of ring cracks and radials in which one tip stopped and one was left, and a tip outside of it.
TEST(PaneMeasures, TipsWithinClosedRegionsAreToldFromOthers) {
  glass::CrackNetwork network;
  network.impacts = {{{150.0, 150.0}, 4, 0, 1}};
  add(network, CrackKind::radial, {{150, 150}, {180, 150}, {200, 150}}, {CrackEnd::At::open, {}});
  add(network, CrackKind::radial, {{150, 150}, {150, 180}}, {CrackEnd::At::crack, 4});
  add(network, CrackKind::radial, {{150, 150}, {160, 165}}, {CrackEnd::At::enclosed, {}});
  add(network, CrackKind::radial, {{150, 150}, {165, 160}, {170, 165}}, {CrackEnd::At::open, {}});
  add(network, CrackKind::circular, {{180, 180}, {150, 180}}, {CrackEnd::At::crack, 1});
  add(network, CrackKind::circular, {{180, 180}, {180, 150}}, {CrackEnd::At::crack, 0});
  EXPECT_EQ(measured(network, square_pane()).impacts[0].enclosed_tips, (EnclosedTips{2, 1}));
  // The edge closes nothing.
  network.cracks[5].end = {CrackEnd::At::open, {}};
  network.cracks[5].points_mm.back() = {180, 151};
  EXPECT_EQ(measured(network, square_pane()).impacts[0].enclosed_tips, EnclosedTips{});
}

TEST(PaneMeasures, AnglesBetweenCracksThatReachTheEdge) {
  glass::CrackNetwork network;
  network.impacts = {{{150.0, 150.0}, 4, 3, 0}};
  const auto add_at = [&](double degrees, double length, CrackEnd::At end) {
    add(network, CrackKind::large, {{150, 150}, vec2{150, 150} + length * Angle::degrees(degrees).direction()}, {end, {}});
  };
  add_at(0.0, 150.0, CrackEnd::At::edge);
  add_at(90.0, 150.0, CrackEnd::At::edge);
  add_at(45.0, 100.0, CrackEnd::At::open);
  EXPECT_EQ(measured(network, square_pane()).impacts[0].reaching_gap_variation, std::nullopt);
  add_at(180.0, 150.0, CrackEnd::At::edge);
  // 90, 90 and 180°.
  EXPECT_NEAR(measured(network, square_pane()).impacts[0].reaching_gap_variation.value(), std::sqrt(2.0) / 4.0, 0.1);
  network.cracks[2].end.at = CrackEnd::At::edge;
  // 45, 45, 90 and 180°.
  EXPECT_GT(measured(network, square_pane()).impacts[0].reaching_gap_variation.value(), 0.55);
}

TEST(PaneMeasures, TurnsAreYoungNearTheImpact) {
  const ImpactMeasures impact = measured(hand_made(), square_pane()).impacts[0];
  ASSERT_EQ(impact.turn_distances_mm.size(), impact.turns.size());
  EXPECT_EQ(impact.room_mm, 150.0);
  EXPECT_NEAR(impact.turn_distances_mm[0], chord_mm, 1e-9);
  EXPECT_NEAR(impact.turn_distances_mm[9], 10.0 * chord_mm, 1e-9);
  EXPECT_TRUE(is_young(impact, 0) && is_young(impact, 4));  // 5 × 4.69 mm, of 25
  EXPECT_FALSE(is_young(impact, 5) || is_grown(impact, 5));
  EXPECT_TRUE(is_grown(impact, 12) && is_grown(impact, 24));  // 60 … 120 mm
  EXPECT_FALSE(is_grown(impact, 11) || is_grown(impact, 25));
}

}  // namespace
}  // namespace shatterpave::measure
