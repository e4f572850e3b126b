#include "pipeline/measure.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "glass/breaking.h"
#include "report/measures.h"
#include "scene/read_scene.h"

namespace shatterpave::pipeline {
namespace {

scene::Scene scene_of(std::string_view more = {}) {
  const std::string text = R"(seed = 40
[[pane]]
name = "window"
size_mm = [120, 90]
impact = [{at_mm = [60, 45], mean_radial_count = 20}, {at_mm = [20, 20], radial_count = 5, large_count = 1}]
)" + std::string(more);
  return scene::scene_of_text(text, "s.toml");
}

constexpr std::string_view second_pane = "[[pane]]\nname = \"other\"\nsize_mm = [50, 50]\nimpact = [{at_mm = [9, 9]}]\n";

TEST(Surveyed, BreaksEachPaneWithEachSeed) {
  const measure::Survey survey = surveyed(scene_of(second_pane), {"s.toml", 3, {}});
  ASSERT_EQ(survey.panes.size(), 6U);
  EXPECT_EQ(survey.pane_names, (std::vector<std::string>{"window", "other"}));
  EXPECT_EQ(survey.panes[0].seed, 40U);
  EXPECT_EQ(survey.panes[1].seed, 40U);
  EXPECT_EQ(survey.panes[5].seed, 42U);
  EXPECT_EQ(survey.panes[5].pane, 1U);
  ASSERT_EQ(survey.panes[4].impacts.size(), 2U);
  EXPECT_EQ(survey.panes[4].impacts[1].drawn.radial_count, 5);
  // As export would have broken it.
  const glass::Pane window = scene_of().panes[0];
  EXPECT_EQ(survey.panes[4].impacts[0].drawn, glass::broken(window, 42).impacts[0]);
  EXPECT_EQ(survey.specimens[4].network, glass::broken(window, 42));
  EXPECT_FALSE(survey.count_law) << "the panes have two laws";
  EXPECT_EQ(surveyed(scene_of(), {"s.toml", 1, {}}).count_law, (measure::CountLaw{20.0, 1.0}));
}

TEST(Surveyed, SweepsTheRadialsEvenly) {
  // Without its own scatter N follows from M alone.
  const scene::Scene scene = scene_of("[pane.growth]\nlarge_deviation = 0\n");
  const measure::Survey survey = surveyed(scene, {"s.toml", 5, measure::Sweep{10, 20}});
  std::vector<int> counts;
  for (const measure::SurveyedPane& pane : survey.panes) {
    counts.push_back(pane.impacts[0].drawn.radial_count);
    EXPECT_EQ(pane.impacts[1].drawn.radial_count, counts.back());
    EXPECT_EQ(pane.impacts[1].drawn.large_count, pane.impacts[0].drawn.large_count) << "N follows from M, not from the scene";
  }
  EXPECT_EQ(counts, (std::vector<int>{10, 13, 15, 18, 20}));
  EXPECT_EQ(surveyed(scene_of(), {"s.toml", 1, measure::Sweep{10, 20}}).panes[0].impacts[0].drawn.radial_count, 10);
}

// By default where the scene has a pane by the letter of the paper, else if asked; tempered and real panes know one law only.
TEST(Surveyed, SetsTheOtherLawBesideThatOfTheScene) {
  const std::string printed = "[pane.growth]\nlaw = \"printed\"\n";
  EXPECT_FALSE(surveyed(scene_of(), {"s.toml", 2, {}}).other_law);
  const measure::Survey asked = surveyed(scene_of(), {"s.toml", 2, {}, true});
  const measure::Survey by_default = surveyed(scene_of(printed), {"s.toml", 2, {}});
  ASSERT_TRUE(asked.other_law && by_default.other_law);
  EXPECT_EQ(asked.other_law->name, "printed");
  EXPECT_EQ(by_default.other_law->name, "fitted");
  EXPECT_EQ(asked.other_law->summary.findings, by_default.summary.findings);
  EXPECT_EQ(by_default.other_law->summary.findings, asked.summary.findings);
  EXPECT_NE(asked.summary.turn_deg, by_default.summary.turn_deg);
  EXPECT_EQ(surveyed(scene_of(printed + std::string(second_pane)), {"s.toml", 2, {}}).other_law->name, "other");
  scene::Scene tempered = scene_of(printed);
  tempered.panes[0].glass = glass::Tempered{};
  EXPECT_FALSE(surveyed(tempered, {"s.toml", 1, {}, true}).other_law);
}

// More panes than a batch, in any number of threads.
TEST(SurveyThreads, DoNotShow) {
  const scene::Scene scene = scene_of(second_pane);
  const MeasureOptions options{"s.toml", 30, {}};
  const auto files = [&](int threads) {
    const ThreadLimit limit(threads);
    const measure::Survey survey = surveyed(scene, options);
    return reporting::measures_csv(survey) + reporting::measures_json(survey);
  };
  const std::string first = files(1);
  EXPECT_EQ(files(2), first);
  EXPECT_EQ(files(5), first);
}

TEST(Surveyed, RefusesWhatItCannotMeasure) {
  const auto message = [](const scene::Scene& scene, const MeasureOptions& options) -> std::string {
    try {
      surveyed(scene, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  scene::Scene paved = scene_of();
  paved.panes.clear();
  EXPECT_EQ(message(paved, {"s.toml", 1, {}}), "s.toml: expected a table [[pane]] or [[pavement]] to measure, got none");
  scene::Scene late = scene_of();
  late.seed = 9223372036854775807;
  EXPECT_EQ(message(late, {"s.toml", 2, {}}),
            "s.toml: expected a first seed of at most 9223372036854775806 for 2 seeds, got 9223372036854775807");
  scene::Scene many = scene_of();
  many.panes.resize(11, many.panes[0]);
  EXPECT_EQ(message(many, {"s.toml", 100'000, {}}),
            "s.toml: expected at most 1000000 panes in all, got 100000 seeds with 11 panes each");
}

}  // namespace
}  // namespace shatterpave::pipeline
