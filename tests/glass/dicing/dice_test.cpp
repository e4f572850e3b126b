#include "glass/dicing/dice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "geometry/lattice.h"
#include "geometry/voronoi.h"
#include "glass/breaking.h"
#include "glass/dicing/dice_shape.h"
#include "glass/network_oracle.h"
#include "glass/random_panes.h"
#include "measure/fragments.h"

namespace shatterpave::glass {
namespace {

Pane tempered_pane(vec2 size_mm, double thickness_mm) {
  Pane pane;
  pane.name = "door";
  pane.outline_mm = {{0.0, 0.0}, {size_mm.x, 0.0}, size_mm, {0.0, size_mm.y}};
  pane.thickness_mm = thickness_mm;
  pane.glass = Tempered{};
  pane.impacts.emplace_back().at_mm = 0.5 * size_mm;
  return pane;
}

// The panel of the photographs that the shape of splinters was set by: 100 × 150 × 3 mm.
Pane panel() {
  Pane pane = tempered_pane({100.0, 150.0}, 3.0);
  std::get<Tempered>(pane.glass).surface_stress_mpa = 135.0;
  return pane;
}

// A slow and independent count: the connected white areas of a picture of the square, 20 px to a millimetre, less half of those
// that reach its border.
double counted_on_picture(const CrackNetwork& network, vec2 low) {
  constexpr int px = 1000;
  constexpr double scale = px / 50.0;
  std::vector<char> dark(static_cast<std::size_t>(px) * px, 0);
  const auto at = [&](int x, int y) -> char& { return dark[static_cast<std::size_t>(y) * px + static_cast<std::size_t>(x)]; };
  const auto is_in = [&](int x, int y) { return x >= 0 && y >= 0 && x < px && y < px; };
  for (const Crack& crack : network.cracks) {
    for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
      const vec2 a = scale * (crack.points_mm[i - 1] - low);
      const vec2 b = scale * (crack.points_mm[i] - low);
      const int steps = static_cast<int>(2.0 * glm::length(b - a)) + 1;
      for (int k = 0; k <= steps; ++k) {
        const vec2 p = glm::mix(a, b, static_cast<double>(k) / steps);
        for (const int step : {0, 1}) {
          const int x = static_cast<int>(std::floor(p.x)) + step;
          const int y = static_cast<int>(std::floor(p.y));
          if (is_in(x, y)) at(x, y) = 1;
        }
      }
    }
  }
  double count = 0.0;
  for (int start = 0; start < px * px; ++start) {
    if (dark[static_cast<std::size_t>(start)] != 0) continue;
    std::vector<int> waiting{start};
    dark[static_cast<std::size_t>(start)] = 1;
    bool cut = false;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      const int x = waiting[i] % px;
      const int y = waiting[i] / px;
      cut = cut || x == 0 || y == 0 || x == px - 1 || y == px - 1;
      for (const auto& [u, v] : {std::pair(x + 1, y), std::pair(x - 1, y), std::pair(x, y + 1), std::pair(x, y - 1)}) {
        if (!is_in(u, v) || at(u, v) != 0) continue;
        at(u, v) = 1;
        waiting.push_back(v * px + u);
      }
    }
    if (waiting.size() > 12) count += cut ? 0.5 : 1.0;  // fewer are what lines leave of a corner
  }
  return count;
}

double least_count(const Pane& pane, std::uint64_t seed) {
  const std::vector<double> counts = measure::fragment_counts(broken(pane, seed), pane);
  EXPECT_FALSE(counts.empty());
  return std::ranges::min(counts);
}

TEST(Dice, NetworksAreSound) {
  Pane corner = tempered_pane({300.0, 200.0}, 4.0);
  corner.impacts = {{}, {}};
  corner.impacts[0].at_mm = {0.5, 0.4};
  corner.impacts[1].at_mm = {200.0, 100.0};
  Pane hook = tempered_pane({300.0, 300.0}, 10.0);
  hook.outline_mm = {{0.0, 0.0}, {300.0, 0.0}, {300.0, 60.0}, {40.0, 60.0}, {40.0, 300.0}, {0.0, 300.0}};
  hook.impacts[0].at_mm = {290.0, 30.0};
  for (const Pane& pane : {panel(), corner, hook}) {
    const CrackNetwork network = broken(pane, 4);
    EXPECT_EQ(faults(network, pane.outline_mm), nothing);
    EXPECT_GT(network.cracks.size(), 300U);
    // All fragments are closed but for what folding and rounding cut off.
    EXPECT_LE(std::ranges::count_if(network.cracks, [](const Crack& crack) { return crack.end.at == CrackEnd::At::open; }), 1);
  }
}

TEST(Dice, NetworksOfOddPanesAreSound) {
  int cracks = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Pane pane = random_pane(seed, {});
    pane.glass = Tempered{};
    // Few fragments, however large or small the pane is: sides of 20 mm, or of a third of a pane, or millimetres.
    const double area = geometry::area(pane.outline_mm);
    std::get<Tempered>(pane.glass).count_per_square = std::clamp(2500.0 / (area / 80.0), 1.0, 2500.0);
    if (area / 2500.0 * fragment_count(pane, std::get<Tempered>(pane.glass)) > 20000.0) continue;
    const CrackNetwork network = broken(pane, seed);
    EXPECT_EQ(faults(network, pane.outline_mm), nothing) << "pane " << seed;
    cracks += static_cast<int>(network.cracks.size());
  }
  EXPECT_GT(cracks, 2000);
}

TEST(Dice, EulersFormulaCountsAsAPictureDoes) {
  Pane pane = tempered_pane({260.0, 100.0}, 6.0);
  pane.impacts[0].at_mm = {30.0, 50.0};
  const CrackNetwork network = broken(pane, 2);
  // One row of squares in the middle; the fourth is the only one 80 mm away and more from the impact and 25 mm from the edges.
  const std::vector<double> counts = measure::fragment_counts(network, pane);
  ASSERT_EQ(counts.size(), 2U);
  EXPECT_NEAR(counts[0], counted_on_picture(network, {130.0, 25.0}), 1.0);
  EXPECT_NEAR(counts[1], counted_on_picture(network, {180.0, 25.0}), 1.0);
}

TEST(Dice, EverySquareHasTheFragmentsOfTheStandard) {
  EXPECT_EQ(least_fragment_count(3.0), 15.0);
  EXPECT_EQ(least_fragment_count(4.0), 40.0);
  EXPECT_EQ(least_fragment_count(12.0), 40.0);
  EXPECT_EQ(least_fragment_count(19.0), 30.0);
  for (const double thickness : {3.0, 4.0, 6.0, 8.0, 10.0, 12.0, 15.0, 19.0}) {
    const Pane pane = tempered_pane({360.0, 360.0}, thickness);
    Pane coarse = pane;  // what weak tempering makes: 85 % of the stress leave half of the fragments
    std::get<Tempered>(coarse.glass).surface_stress_mpa = 85.0;
    EXPECT_GE(least_count(pane, 3), least_fragment_count(thickness)) << thickness << " mm";
    EXPECT_LT(least_count(coarse, 3), least_fragment_count(thickness)) << thickness << " mm, twin";
  }
}

TEST(Dice, CountIsWhatWasAskedFor) {
  const auto is_as_asked = [](const Pane& pane, double asked) {
    const std::vector<double> counts = measure::fragment_counts(broken(pane, 9), pane);
    double sum = 0.0;
    for (const double count : counts) sum += count;
    return std::abs(sum / static_cast<double>(counts.size()) / asked - 1.0) < 0.03;
  };
  Pane pane = tempered_pane({500.0, 500.0}, 6.0);
  pane.impacts[0].at_mm = {60.0, 60.0};
  std::get<Tempered>(pane.glass).count_per_square = 80.0;
  EXPECT_TRUE(is_as_asked(pane, 80.0));
  std::get<Tempered>(pane.glass).count_per_square = 75.0;
  EXPECT_FALSE(is_as_asked(pane, 80.0));
}

TEST(Dice, SplintersRadiateNearTheImpactAndBreakUpBeyond) {
  const Pane pane = tempered_pane({400.0, 400.0}, 3.0);
  Pane twin = pane;
  std::get<Tempered>(twin.glass).splinter_ratio = 1.0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const CrackNetwork network = broken(pane, seed);
    const double near = measure::radiality(network, 15.0, 50.0);
    EXPECT_GT(near, 0.6);
    // Far out fragments are still drawn out, but far less.
    const double far = measure::radiality(network, 120.0, 200.0);
    EXPECT_GT(far, 0.12);
    EXPECT_LT(far, 0.75 * near);
    EXPECT_LT(far, 0.5);
    EXPECT_LT(std::abs(measure::radiality(broken(twin, seed), 15.0, 50.0)), 0.15);
  }
  // The thicker the glass, the shorter they are.
  const Pane thick = tempered_pane({400.0, 400.0}, 19.0);
  EXPECT_LT(measure::radiality(broken(thick, 1), 15.0, 50.0) + 0.2, measure::radiality(broken(pane, 1), 15.0, 50.0));
}

// How far the most nearly straight way through a junction of three turns, in the median, in degrees. Each junction is a corner
// with what lies round it.
double median_turn(const std::vector<std::vector<vec2>>& junctions) {
  std::vector<double> turns;
  for (const std::vector<vec2>& around : junctions) {
    double straightest = 180.0;
    for (std::size_t i = 1; i < around.size(); ++i) {
      for (std::size_t j = i + 1; j < around.size(); ++j) {
        const vec2 a = around[0] - around[i];
        const vec2 b = around[j] - around[0];
        straightest = std::min(straightest, std::abs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b))) * 180.0 / pi);
      }
    }
    turns.push_back(straightest);
  }
  std::ranges::nth_element(turns, turns.begin() + static_cast<std::ptrdiff_t>(turns.size() / 2));
  return turns[turns.size() / 2];
}

using Corner = std::pair<double, double>;
Corner corner_at(vec2 p) { return {p.x, p.y}; }

// Those of a network, where three sides meet: each corner, and then the ends of its sides.
std::vector<std::vector<vec2>> junctions_of(const CrackNetwork& network) {
  std::map<Corner, std::vector<vec2>> around;
  for (const Crack& crack : network.cracks) {
    for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
      around[corner_at(crack.points_mm[i - 1])].push_back(crack.points_mm[i]);
      around[corner_at(crack.points_mm[i])].push_back(crack.points_mm[i - 1]);
    }
  }
  std::vector<std::vector<vec2>> junctions;
  for (auto& [corner, others] : around) {
    if (others.size() != 3) continue;
    others.insert(others.begin(), vec2{corner.first, corner.second});
    junctions.push_back(std::move(others));
  }
  return junctions;
}

// The twin: cells of seeds drawn by lot, which meet as bubbles of foam do.
std::vector<std::vector<vec2>> junctions_of_foam() {
  std::vector<vec2> seeds;
  for (std::uint64_t i = 0; i < 40; ++i) {
    for (std::uint64_t j = 0; j < 40; ++j) {
      const Id id = Id("foam").child(i).child(j);
      const vec2 off{uniform(1, {Stream::dice_seed, id, 0}), uniform(1, {Stream::dice_seed, id, 1})};
      seeds.push_back(geometry::on_lattice(8.0 * (vec2{static_cast<double>(i), static_cast<double>(j)} + off)));
    }
  }
  geometry::sort_distinct(seeds);
  const geometry::Voronoi cells = geometry::voronoi(seeds);
  std::map<std::uint32_t, std::vector<vec2>> around;
  for (const auto& cell : cells.cells) {
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const std::uint32_t to = cell[(k + 1) % cell.size()];
      std::vector<vec2>& corner = around[cell[k]];
      if (corner.empty()) corner.push_back(cells.corners[cell[k]]);
      corner.push_back(cells.corners[to]);
    }
  }
  std::vector<std::vector<vec2>> junctions;
  for (auto& [corner, places] : around) {
    if (places.size() == 4) junctions.push_back(std::move(places));
  }
  return junctions;
}

// As in photographs of crazed panes, cracks run straight through many corners, and others end on them. Foam turns by 40° or so.
TEST(Dice, CracksRunThroughCorners) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const double turn = median_turn(junctions_of(broken(tempered_pane({400.0, 400.0}, 5.0), seed)));
    EXPECT_LT(turn, 20.0) << seed;
    EXPECT_GT(turn, 4.0) << seed << ": a wall of bricks";
  }
  EXPECT_GT(median_turn(junctions_of_foam()), 28.0);
}

// Cracks that cross a circle about the impact, on the mean of 24 panes.
double lines_at(const Pane& pane, double radius_mm) {
  double lines = 0.0;
  constexpr int seeds = 24;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    for (const Crack& crack : broken(pane, seed).cracks) {
      for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
        const bool in = glm::length(crack.points_mm[i - 1] - pane.impacts[0].at_mm) < radius_mm;
        if (in != (glm::length(crack.points_mm[i] - pane.impacts[0].at_mm) < radius_mm)) lines += 1.0 / seeds;
      }
    }
  }
  return lines;
}

// In photographs of panes of 3 mm: 1.75 mm apart from 5 to 40 mm from the impact.
TEST(Dice, CracksBranchSoThatTheyStayAsFarApart) {
  const Pane pane = tempered_pane({300.0, 300.0}, 3.0);
  for (const auto& [radius, lines] :
       {std::pair(5.0, 17.0), std::pair(10.0, 39.0), std::pair(20.0, 71.0), std::pair(40.0, 137.0)}) {
    EXPECT_NEAR(lines_at(pane, radius), lines, 0.15 * lines) << radius;
  }
  Pane wide = pane;
  std::get<Tempered>(wide.glass).splinter_ratio = 3.5;
  EXPECT_LT(lines_at(wide, 20.0), 0.85 * 71.0);
}

TEST(Dice, ShapeFoldsBackWhatItUnfolds) {
  const Pane pane = panel();
  const DiceShape shape(pane, std::get<Tempered>(pane.glass), {50.0, 75.0}, 200.0);
  for (const double r : {0.0, 0.004, 0.3, 2.0, 17.0, 80.0, 199.0}) {
    const vec2 p = vec2{50.0, 75.0} + r * Angle::degrees(33.0).direction();
    EXPECT_LT(glm::length(shape.folded(shape.unfolded(p)) - p), 1e-9) << r;
  }
  EXPECT_NEAR(shape.length_mm(30.0) / shape.width_mm(30.0), 7.0, 0.01);
}

TEST(Dice, IsAFunctionOfPaneAndSeed) {
  const Pane pane = panel();
  EXPECT_EQ(broken(pane, 5), broken(pane, 5));
  EXPECT_NE(broken(pane, 5), broken(pane, 6));
  Pane again = pane;
  again.impacts.emplace_back().at_mm = {20.0, 20.0};
  EXPECT_EQ(broken(pane, 5).cracks, broken(again, 5).cracks);
}

TEST(Dice, RefusesPanesOfTooManyFragments) { EXPECT_THROW(broken(tempered_pane({10'000.0, 10'000.0}, 6.0), 1), InputError); }

}  // namespace
}  // namespace shatterpave::glass
