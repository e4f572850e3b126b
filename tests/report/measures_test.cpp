// The files of `measure`: the page's plots are tried in a browser by tests/scripts/measure_test.sh.
#include "report/measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "measure/count_law.h"
#include "report/words.h"

namespace shatterpave::reporting {
namespace {

using measure::Finding;
using measure::Verdict;

// Two seeds of one pane: the first has a ring crack and two turns, the second next to nothing.
measure::Survey small_survey() {
  measure::Survey survey;
  survey.name = "a&b";
  survey.pane_names = {"window"};
  survey.first_seed = 7;
  survey.seed_count = 2;
  measure::ImpactMeasures full;
  full.drawn = {{1.0, 1.0}, 100, 9, 5};
  full.reaching_count = 8;
  full.ends = {8, 2, 1, 99};
  full.ring_crack_count = 10;
  full.held_ring_end_count = 9;
  full.ring_distances_mm = {60.0, 62.0};
  full.turns = {Angle::radians(0.0), Angle::radians(0.0)};
  full.room_mm = 1.0;
  full.turn_distances_mm = {0.1, 0.5};
  full.reaching_gap_variation = 0.125;
  full.gap_ratio = 0.25;
  measure::ImpactMeasures bare;
  bare.drawn = {{1.0, 1.0}, 24, 5, 0};
  survey.panes = {{7, 0, {figures_of(full)}}, {8, 0, {figures_of(bare)}}};
  measure::Totals totals;
  for (const measure::ImpactMeasures& of : {full, bare}) {
    measure::PaneMeasures pane;
    pane.impacts = {of};
    totals.add(pane);
  }
  survey.summary = totals.summary();
  survey.pane_summaries = {survey.summary};
  glass::Crack crack;
  crack.kind = glass::CrackKind::large;
  crack.points_mm = {{1.0, 1.0}, {2.0, 1.5}};
  glass::Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}};
  survey.specimens = {{7, pane, {{full.drawn}, {crack}}}};
  return survey;
}

TEST(Measures, CsvHasOneRowForEachImpactAndIsEmptyWhereNothingWasMeasured) {
  const std::string csv = measures_csv(small_survey());
  const std::size_t rows = csv.find('\n') + 1;
  EXPECT_EQ(csv.substr(rows),
            "7,window,0,100,9,5,8,8,2,1,99,10,9,2,61,1.4142135623730951,60,62,2,0,0,0,0,0,,,,,0.25,0,1,,1,,0.125\n"
            "8,window,0,24,5,0,0,0,0,0,0,0,0,0,,,,,0,,,,,0,,,,,,0,0,,0,,\n");
  const std::string head = csv.substr(0, rows);
  EXPECT_EQ(std::ranges::count(head, ','), 34);
  EXPECT_TRUE(head.starts_with("seed,pane,impact,radial_count,large_count,circular_count,reaching_count,"));
}

TEST(Measures, JsonHoldsTheFindings) {
  const nlohmann::json json = nlohmann::json::parse(measures_json(small_survey()));
  EXPECT_EQ(json.at("format"), "shatterpave-measures");
  EXPECT_EQ(json.at("scene"), "a&b");
  EXPECT_EQ(json.at("first_seed"), 7);
  EXPECT_EQ(json.at("seeds"), 2);
  EXPECT_TRUE(json.at("radials").is_null());
  EXPECT_EQ(json.at("panes").at(0).at("name"), "window");
  EXPECT_TRUE(json.at("other_law").is_null());
  EXPECT_EQ(json.at("all").at("turn_deg_by_distance").at(0).at("to_mm"), 12.5);
  EXPECT_EQ(json.at("all").at("turn_deg_by_distance").at(0).at("count"), 2);
  const nlohmann::json& findings = json.at("all").at("findings");
  ASSERT_EQ(findings.size(), 19U);
  EXPECT_EQ(findings[0].at("id"), "large_slope");
  EXPECT_EQ(findings[0].at("verdict"), "open");
  EXPECT_EQ(findings[0].at("standard_error"), nullptr) << "two points have no error";
  EXPECT_EQ(findings[9].at("id"), "ring_ends");
  EXPECT_EQ(findings[9].at("figure"), 90.0);
  EXPECT_EQ(findings[9].at("high"), nullptr);
  EXPECT_EQ(findings[9].at("verdict"), "fails");
}

TEST(Measures, FilesAreNamedAfterTheScene) {
  const std::vector<exporting::OutputFile> files = measures_files(small_survey());
  ASSERT_EQ(files.size(), has_plots() ? 3U : 2U);
  EXPECT_EQ(files[0].name, "a&b-measures.csv");
  EXPECT_EQ(files[1].name, "a&b-measures.json");
  if (has_plots()) {
    EXPECT_EQ(files[2].name, "a&b-measures.html");
  }
}

// The tests are built with the plotting library (tests/run.sh), else this is left to the command's own message.
TEST(Measures, ReportIsWholeAndEscaped) {
  if (!has_plots()) return;
  const std::string page = measures_report(small_survey());
  EXPECT_EQ(page.find("<!--@"), std::string::npos) << "a mark was left";
  EXPECT_EQ(page.find("By the law"), std::string::npos);
  measure::Survey both = small_survey();
  both.other_law = measure::OtherLaw{"printed", both.summary};
  EXPECT_NE(measures_report(both).find("<th class=\"number\">By the law “printed”</th>"), std::string::npos);
  EXPECT_NE(page.find("<h1>a&amp;b</h1>"), std::string::npos);
  EXPECT_NE(page.find("Redistribution and use in source and binary forms"), std::string::npos);
  // Five script elements, each ended once: nothing in the libraries ends one before.
  std::size_t ends = 0;
  for (std::size_t at = page.find("</script"); at != std::string::npos; at = page.find("</script", at + 1)) ++ends;
  EXPECT_EQ(ends, 5U);
}

TEST(Words, TellTargetsAndFigures) {
  const Finding slope{"", "", "", 0.0555, 0.0675, 0.06081, 0.0012, 200, "panes", Verdict::holds};
  EXPECT_EQ(target_of(slope), "0.0615 ± 0.006");
  EXPECT_EQ(figure_of(slope), "0.0608 ± 0.0012");
  const Finding share{"", "", "%", 99.0, HUGE_VAL, 99.949, 0.0, 200, "turns", Verdict::holds};
  EXPECT_EQ(target_of(share), "≥ 99 %");
  EXPECT_EQ(figure_of(share), "99.9 %");
  const Finding mean{"", "", "°", -0.5, 0.5, -0.0123, 0.01, 200, "turns", Verdict::holds};
  EXPECT_EQ(target_of(mean), "0 ± 0.5°");
  EXPECT_EQ(figure_of(mean), "−0.01 ± 0.01°");
  const Finding none{"", "", "", 0.0, 0.0, 0.0, 0.0, 0, "panes", Verdict::open};
  EXPECT_EQ(target_of(none), "0");
  EXPECT_EQ(figure_of(none), "–");
  const Finding limit{"", "", "", -HUGE_VAL, 1.2, 0.37, 0.0, 200, "panes", Verdict::holds};
  EXPECT_EQ(target_of(limit), "≤ 1.2");
  EXPECT_EQ(figure_of(limit), "0.37");
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1234567), "1,234,567");
}

}  // namespace
}  // namespace shatterpave::reporting
