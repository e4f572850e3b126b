#include "measure/summary.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "measure/experiment.h"

namespace shatterpave::measure {
namespace {

// A pane as Table 1 would have it: `large` reach the edge.
PaneMeasures pane(int radial_count, int large) {
  PaneMeasures measures;
  ImpactMeasures& impact = measures.impacts.emplace_back();
  impact.drawn.radial_count = radial_count;
  impact.reaching_count = large;
  return measures;
}

Verdict verdict(const Totals& totals, std::string_view id) { return finding(totals.summary(), id).verdict; }

TEST(Summary, OfNothingIsOpen) {
  const Summary summary = Totals().summary();
  EXPECT_EQ(summary.findings.size(), 19U);
  for (const Finding& finding : summary.findings) EXPECT_EQ(finding.verdict, Verdict::open) << finding.id;
  EXPECT_THROW(finding(summary, "none"), BrokenInvariant);
}

// Table 1 itself, ten times over so that its errors are small enough.
TEST(Summary, TableOneHolds) {
  Totals totals;
  for (int i = 0; i < 10; ++i) {
    for (const ExperimentPane& measured : experiment_panes()) totals.add(pane(measured.radial_count, measured.large_count));
  }
  EXPECT_EQ(verdict(totals, "large_slope"), Verdict::holds);
  EXPECT_EQ(verdict(totals, "large_intercept"), Verdict::holds);
  EXPECT_EQ(verdict(totals, "large_residual"), Verdict::holds);
  EXPECT_EQ(totals.summary().radial_count.count(), 190U);
  EXPECT_NEAR(totals.summary().radial_count.mean(), 95.7, 0.05);
}

TEST(Summary, LinesOfFewPanesOrOfOneCountAreOpen) {
  Totals few;
  for (const ExperimentPane& measured : experiment_panes()) few.add(pane(measured.radial_count, measured.large_count));
  EXPECT_EQ(verdict(few, "large_slope"), Verdict::open);
  EXPECT_EQ(verdict(few, "large_residual"), Verdict::open);
  Totals one_count;
  for (int i = 0; i < 100; ++i) one_count.add(pane(114, 9 + i % 3));
  EXPECT_EQ(verdict(one_count, "large_slope"), Verdict::open);
  EXPECT_EQ(one_count.summary().large_line.intercept, finding(one_count.summary(), "large_intercept").figure);
}

TEST(Summary, SharesAreOfWhatWasSeen) {
  PaneMeasures measures = pane(100, 9);
  ImpactMeasures& impact = measures.impacts[0];
  for (int i = 0; i < 200; ++i) impact.turns.push_back(Angle::degrees(i % 2 == 0 ? 5.0 : -5.0));
  impact.turns.push_back(Angle::degrees(27.4));
  impact.turns.push_back(Angle::degrees(-22.6));
  impact.room_mm = 150.0;
  impact.turn_distances_mm.resize(202, 100.0);
  impact.turn_distances_mm[0] = 20.0;
  impact.turn_distances_mm[1] = 20.0;
  impact.reaching_gap_variation = 0.1;
  impact.enclosed_tips = {10, 9};
  impact.ring_crack_count = 20;
  impact.held_ring_end_count = 19;
  impact.edge_angles = {Angle::degrees(80.0), Angle::degrees(74.0)};
  impact.ring_distances_mm = {60.9 * 0.9, 60.9 * 1.2};
  impact.gap_ratio = 0.25;
  Totals totals;
  totals.add(measures);
  const Summary summary = totals.summary();
  EXPECT_NEAR(finding(summary, "turns_in_range").figure, 100.0 * 201.0 / 202.0, 1e-9);
  EXPECT_EQ(finding(summary, "turns_in_range").verdict, Verdict::holds);
  EXPECT_EQ(finding(summary, "left_turns").verdict, Verdict::open) << "202 turns tell 50 ± 3.5 %";
  EXPECT_EQ(finding(summary, "ring_ends").figure, 95.0);
  EXPECT_EQ(finding(summary, "ring_ends").verdict, Verdict::holds);
  EXPECT_EQ(finding(summary, "edge_angles").verdict, Verdict::fails);
  EXPECT_EQ(finding(summary, "radial_gaps").figure, 0.25);
  EXPECT_EQ(finding(summary, "young_turns").count, 2U);
  EXPECT_EQ(finding(summary, "young_turns").verdict, Verdict::fails) << "they turn as the others do";
  EXPECT_EQ(summary.turns_deg_by_distance[1].count(), 2U);
  EXPECT_EQ(summary.turns_deg_by_distance[8].count(), 200U);
  EXPECT_NEAR(finding(summary, "reaching_gaps").figure, 10.0, 1e-12);
  EXPECT_EQ(finding(summary, "enclosed_tips").figure, 90.0);
  EXPECT_EQ(finding(summary, "enclosed_tips").verdict, Verdict::fails);
  EXPECT_NEAR(summary.ring_offset_mm.mean(), 60.9 * 0.05, 1e-9);
  EXPECT_EQ(summary.ring_ratios.counts[18] + summary.ring_ratios.counts[17], 1U);
  EXPECT_EQ(summary.turns_deg.counts[40], 100U);  // 5 … 6.25°

  measures.impacts.push_back(measures.impacts[0]);
  measures.impacts[1].crossing_count = 1;
  totals.add(measures);
  EXPECT_EQ(finding(totals.summary(), "crossings").verdict, Verdict::fails) << "those of later impacts count too";
  EXPECT_EQ(totals.summary().radial_count.count(), 2U) << "all else is of the first impact";
}

TEST(Totals, HoldOnlyPanesOfThePapersKindAgainstItsPanes) {
  PaneMeasures measures;
  ImpactMeasures& impact = measures.impacts.emplace_back();
  impact.drawn.radial_count = 100;
  impact.ring_crack_count = 4;
  impact.held_ring_end_count = 4;
  impact.edge_angles = {Angle::degrees(80.0)};
  measures.subject = Subject::dice;
  measures.fragment_counts = {40.0, 39.5, 61.0};
  measures.least_fragment_count = 40.0;
  Totals totals;
  totals.add(measures);
  EXPECT_EQ(finding(totals.summary(), "large_slope").count, 0U);
  EXPECT_EQ(finding(totals.summary(), "edge_angles").verdict, Verdict::open);
  EXPECT_EQ(finding(totals.summary(), "ring_ends").verdict, Verdict::open);
  EXPECT_EQ(finding(totals.summary(), "crossings").verdict, Verdict::holds);
  EXPECT_EQ(finding(totals.summary(), "fragments").figure, 1.0) << "the square of 39.5";
  EXPECT_EQ(finding(totals.summary(), "fragments").verdict, Verdict::fails);
  measures.subject = Subject::rings;
  measures.fragment_counts.clear();
  totals.add(measures);
  EXPECT_EQ(finding(totals.summary(), "ring_ends").count, 4U);
  EXPECT_EQ(finding(totals.summary(), "edge_angles").verdict, Verdict::open);
  measures.subject = Subject::experiment;
  totals.add(measures);
  EXPECT_EQ(finding(totals.summary(), "edge_angles").count, 1U);
}

}  // namespace
}  // namespace shatterpave::measure
