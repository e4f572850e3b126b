// The twelve experiments of §4.3 as they come out, over seeds: what the paper says of Figs. 14 to 16. Seeds are fixed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "glass/breaking.h"
#include "glass/presets.h"
#include "measure/distribution.h"
#include "measure/pane_measures.h"
#include "support/laws.h"

namespace shatterpave::measure {
namespace {

glass::Pane pane_of(const glass::Preset& preset) {
  glass::Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0.0, 0.0}, {300.0, 0.0}, {300.0, 300.0}, {0.0, 300.0}};
  pane.growth = preset.growth;
  glass::Impact impact;
  impact.at_mm = {150.0, 150.0};
  impact.radial_count = preset.radial_count;
  impact.large_count = preset.large_count;
  impact.circular_count = preset.circular_count;
  pane.impacts = {impact};
  return pane;
}

// Measures of panes of one kind with different seeds.
std::vector<ImpactMeasures> measures_of(const glass::Pane& pane, std::size_t count, std::uint64_t first_seed) {
  std::vector<ImpactMeasures> result(count);
  parallel_for(count, [&](std::size_t i) { result[i] = measured(glass::broken(pane, first_seed + i), pane).impacts.front(); });
  return result;
}

TEST(PresetStatistics, CountsAreThePrintedOnesAndLargeCracksReachTheEdge) {
  int large = 0;
  int reaching = 0;
  for (const glass::Preset& preset : glass::presets()) {
    double of_preset = 0.0;
    const std::vector<ImpactMeasures> panes = measures_of(pane_of(preset), 8, 300);
    for (const ImpactMeasures& pane : panes) {
      EXPECT_EQ(pane.drawn.radial_count, preset.radial_count) << preset.name;
      EXPECT_EQ(pane.drawn.large_count, preset.large_count) << preset.name;
      EXPECT_EQ(pane.drawn.circular_count, preset.circular_count) << preset.name;
      EXPECT_EQ(pane.crossing_count, 0) << preset.name;
      of_preset += pane.reaching_count;
    }
    large += 8 * preset.large_count;
    reaching += static_cast<int>(of_preset);
    // The regression of Table 1 (slope 0.0615, intercept 3.06), with the residual of its panes.
    EXPECT_NEAR(of_preset / 8.0, 0.0615 * preset.radial_count + 3.06, 1.2) << preset.name;
  }
  EXPECT_GE(static_cast<double>(reaching) / large, 0.95);
  // The twin: rings that start at once cut large cracks off.
  glass::Pane cut_off = pane_of(glass::presets()[4]);
  cut_off.growth.ring_onset = 0.0;
  double left = 0.0;
  for (const ImpactMeasures& pane : measures_of(cut_off, 16, 300)) left += pane.reaching_count;
  EXPECT_LT(left / 16.0 / glass::presets()[4].large_count, 0.9);
}

// Standard deviation of the turns, in degrees, of each of `count` panes. Turns within a pane depend on one another, those of
// different panes do not.
std::vector<double> turn_deviations(const glass::Pane& pane, std::size_t count, std::uint64_t first_seed) {
  std::vector<double> result;
  for (const ImpactMeasures& impact : measures_of(pane, count, first_seed)) {
    Distribution turns;
    for (const Angle turn : impact.turns) turns.add(turn.degrees());
    result.push_back(turns.deviation());
  }
  return result;
}

double mean_of(const std::vector<double>& values) {
  Distribution all;
  for (const double value : values) all.add(value);
  return all.mean();
}

// "Larger V1 gives straighter large cracks": Fig. 14, whose panes differ in V1.
TEST(PresetStatistics, FasterLargeCracksAreStraighter) {
  const auto deviations = [](double weight_time) {
    std::vector<double> result;
    for (const double speed : {30.0, 40.0, 50.0, 60.0}) {
      glass::Pane pane = pane_of(glass::presets()[0]);
      pane.growth.large_speed = speed;
      pane.growth.weight_time = weight_time;
      result.push_back(mean_of(turn_deviations(pane, 24, 500)));
    }
    return result;
  };
  const std::vector<double> model = deviations(10.0);
  for (std::size_t i = 1; i < model.size(); ++i) EXPECT_LT(model[i], 0.98 * model[i - 1]) << i;
  EXPECT_LT(model.back(), 0.7 * model.front());
  // The twin: cracks that turn as readily from the start are hardly straighter for being fast.
  const std::vector<double> twin = deviations(0.01);
  EXPECT_GT(twin.back(), 0.7 * twin.front());
  RecordProperty("model", testing::PrintToString(model));
  RecordProperty("twin", testing::PrintToString(twin));
}

// "Normal and uniform numbers give the same look": Figs. 15 and 16 cannot be told apart by their turns. One value a pane.
TEST(PresetStatistics, NormalAndUniformSpreadLookAlike) {
  constexpr std::size_t count = 60;
  glass::Pane pane = pane_of(glass::presets()[4]);
  const std::vector<double> normal = turn_deviations(pane, count, 700);
  pane.growth.spread = glass::Spread::uniform;
  EXPECT_GT(support::kolmogorov_p(normal, turn_deviations(pane, count, 1700)), support::significance());
  // The twin, which shows that so many panes can tell: 30 % more wander.
  pane.growth.wander = pane.growth.wander * 1.3;
  EXPECT_LT(support::kolmogorov_p(normal, turn_deviations(pane, count, 1700)), support::significance());
}

}  // namespace
}  // namespace shatterpave::measure
