#include "measure/scene_fit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "glass/breaking.h"

namespace shatterpave::measure {
namespace {

glass::Pane pane_with(double wander_deg, double branches_per_m) {
  glass::Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0.0, 0.0}, {300.0, 0.0}, {300.0, 300.0}, {0.0, 300.0}};
  glass::Impact impact;
  impact.at_mm = {150.0, 150.0};
  impact.radial_count = 40;
  pane.impacts = {impact};
  pane.growth.wander = Angle::degrees(wander_deg);
  pane.growth.branch_rate_per_m = branches_per_m;
  return pane;
}

SceneFit fit_of(const glass::Pane& pane) {
  std::vector<PaneFigures> figures;
  for (std::uint64_t seed = 500; seed < 506; ++seed) figures.push_back(pane_figures(glass::broken(pane, seed), pane));
  return fitted_scene(figures, pane);
}

const FittedValue& value(const SceneFit& fit, std::string_view key) {
  return *std::ranges::find(fit.values, key, &FittedValue::key);
}

// Of six panes: what they were grown with is found within twice the stated error, and a scene with another crookedness is told
// apart.
TEST(SceneFit, FindsWhatPanesWereGrownWith) {
  const SceneFit fit = fit_of(pane_with(24.0, 0.0));
  EXPECT_EQ(fit.pane.pattern, glass::Pattern::agui1992);
  EXPECT_EQ(value(fit, "impact[0].radial_count").value, 40.0);
  const FittedValue& wander = value(fit, "growth.wander_deg");
  EXPECT_NEAR(wander.value, 24.0, 2.0 * wander.error);
  EXPECT_GT(wander.value, 12.0 + 2.0 * wander.error);
  EXPECT_GT(fit.probability, 0.05);
}

TEST(SceneFit, FindsBranches) {
  const SceneFit fit = fit_of(pane_with(14.0, 8.0));
  const FittedValue& rate = value(fit, "growth.branch_rate_per_m");
  EXPECT_NEAR(rate.value, 8.0, 2.0 * rate.error);
  EXPECT_GT(rate.value, 2.0 * rate.error);
}

// Panes of two different scenes taken together are not those of one.
TEST(SceneFit, TellsWhatIsOfNoOneScene) {
  PaneFigures odd = pane_figures(glass::broken(pane_with(14.0, 0.0), 500), pane_with(14.0, 0.0));
  odd.turn_correlation = -0.8;
  odd.gap_variation = 3.0;
  EXPECT_LT(fitted_scene({odd}, pane_with(14.0, 0.0)).probability, 0.05);
}

}  // namespace
}  // namespace shatterpave::measure
