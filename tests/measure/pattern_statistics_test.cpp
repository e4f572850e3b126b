// Panes of pattern "real" against what photographs of broken glass measure, over 200 seeds; and beside each rule a pane that
// goes without it, of which the figure must say so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "core/functions.h"
#include "core/parallel.h"
#include "glass/breaking.h"
#include "measure/distribution.h"
#include "measure/pattern_measures.h"
#include "measure/pattern_totals.h"

namespace shatterpave::measure {
namespace {

constexpr std::size_t seeds = 200;

glass::Pane real_pane() {
  glass::Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0.0, 0.0}, {300.0, 0.0}, {300.0, 300.0}, {0.0, 300.0}};
  pane.pattern = glass::Pattern::real;
  glass::Impact impact;
  impact.at_mm = {150.0, 150.0};
  pane.impacts = {impact};
  return pane;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

struct Ensemble {
  std::array<Distribution, 3> radial_counts;
  Distribution gap_variation;
  Distribution ring_variation;
  double joints = 0.0;
  double staggered = 0.0;
  double sectors = 0.0;
  double gaps = 0.0;
  double chips = 0.0;
  Distribution log_area;
  std::vector<double> elongations;
  std::vector<double> solidities;
  std::vector<double> kinks_deg;
  PatternTotals totals;
};

Ensemble ensemble(const glass::Pane& pane, std::size_t count = seeds) {
  std::vector<PatternMeasures> all(count);
  parallel_for(count, [&](std::size_t i) { all[i] = pattern_measures(glass::broken(pane, 1 + i), pane); });
  Ensemble sums;
  for (const PatternMeasures& one : all) {
    sums.totals.add(one);
    for (std::size_t k = 0; k < 3; ++k) sums.radial_counts[k].add(one.radial_counts[k]);
    if (one.gap_variation) sums.gap_variation.add(*one.gap_variation);
    for (const double variation : one.ring_variations) sums.ring_variation.add(variation);
    sums.joints += one.joint_count;
    sums.staggered += one.staggered_count;
    sums.sectors += one.sector_count;
    sums.gaps += one.gap_count;
    sums.chips += one.chip_count;
    for (const PieceMeasures& piece : one.pieces) {
      sums.log_area.add(logarithm(piece.area_mm2));
      sums.elongations.push_back(piece.elongation);
      sums.solidities.push_back(piece.solidity);
    }
    sums.kinks_deg.insert(sums.kinks_deg.end(), one.kinks_deg.begin(), one.kinks_deg.end());
  }
  return sums;
}

const Ensemble& real() {
  static const Ensemble sums = ensemble(real_pane());
  return sums;
}

TEST(PatternStatistics, RadialsThinOutAsInPhotographs) {
  const double first = real().radial_counts[0].mean();
  EXPECT_NEAR(real().radial_counts[1].mean() / first, 16.5 / 23.0, 0.2 * 16.5 / 23.0);
  EXPECT_NEAR(real().radial_counts[2].mean() / first, 13.0 / 23.0, 0.2 * 13.0 / 23.0);
  // Where all reach the edge, none is lost.
  glass::Pane all_large = real_pane();
  all_large.impacts[0].radial_count = 30;
  all_large.impacts[0].large_count = 30;
  const Ensemble twin = ensemble(all_large, 10);
  EXPECT_GT(twin.radial_counts[2].mean() / twin.radial_counts[0].mean(), 1.2 * 13.0 / 23.0);
}

TEST(PatternStatistics, GapsBetweenRadialsVary) { EXPECT_GE(real().gap_variation.mean(), 0.4); }

TEST(PatternStatistics, RingsAreStaggeredChordsWithGaps) {
  EXPECT_GE(real().staggered / real().joints, 0.4);
  EXPECT_LE(real().staggered / real().joints, 0.6);
  EXPECT_GE(real().ring_variation.mean(), 0.10);
  EXPECT_LE(real().ring_variation.mean(), 0.16);
  EXPECT_NEAR(real().gaps / real().sectors, 0.25, 0.04);
  // Pieces that keep to their ring meet everywhere, and have one radius.
  glass::Pane even = real_pane();
  even.rings.spread = 0.0;
  const Ensemble twin = ensemble(even, 20);
  EXPECT_LT(twin.staggered / twin.joints, 0.4);
  EXPECT_LT(twin.ring_variation.mean(), 0.10);
}

TEST(PatternStatistics, PiecesAreAsInPhotographs) {
  EXPECT_NEAR(real().log_area.deviation(), 1.5, 0.25);
  EXPECT_GE(median(real().elongations), 2.2);
  EXPECT_LE(median(real().elongations), 2.8);
  EXPECT_GE(median(real().solidities), 0.93);
  // The paper's pattern leaves long strips.
  glass::Pane paper = real_pane();
  paper.pattern = glass::Pattern::agui1992;
  EXPECT_GT(median(ensemble(paper, 20).elongations), 2.8);
}

// As `measure` tells it.
TEST(PatternStatistics, EveryFindingHolds) {
  const std::vector<Finding> findings = real().totals.findings();
  EXPECT_EQ(findings.size(), 11U);
  for (const Finding& finding : findings) {
    EXPECT_EQ(finding.verdict, Verdict::holds) << finding.id << ": " << finding.figure << " ± " << finding.error;
    EXPECT_GE(finding.count, seeds) << finding.id;
  }
  // Pieces as large far out as near the impact.
  PatternMeasures even;
  even.first_ring_mm = 30.0;
  even.room_mm = 150.0;
  for (int i = 0; i < 200; ++i) even.pieces.push_back({40.0 + i % 7, 31.0 + 0.4 * i, 1.5, 1.0, false});
  PatternTotals totals;
  totals.add(even);
  EXPECT_EQ(finding_of(totals.findings(), "real_piece_growth").verdict, Verdict::fails);
}

TEST(PatternStatistics, RadialsKinkAtJunctionsAndHaveChips) {
  EXPECT_GT(median(real().kinks_deg), 3.0);
  EXPECT_GT(real().chips / static_cast<double>(seeds), 10.0);
}

}  // namespace
}  // namespace shatterpave::measure
