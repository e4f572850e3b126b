#include "measure/line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "measure/distribution.h"
#include "measure/experiment.h"

namespace shatterpave::measure {
namespace {

// By hand: means 2 and 4; xx = 2, xy = 3, so slope 1.5 and intercept 1; residuals 0.5, −1, 0.5.
TEST(FittedLine, IsTheOneOfLeastSquares) {
  const std::vector<vec2> points = {{1.0, 3.0}, {2.0, 3.0}, {3.0, 6.0}};
  const Line line = fitted_line(points);
  EXPECT_EQ(line.count, 3U);
  EXPECT_DOUBLE_EQ(line.slope, 1.5);
  EXPECT_DOUBLE_EQ(line.intercept, 1.0);
  EXPECT_DOUBLE_EQ(line.residual, std::sqrt(1.5));
  EXPECT_DOUBLE_EQ(line.correlation, 3.0 / std::sqrt(2.0 * 6.0));
  EXPECT_DOUBLE_EQ(line.slope_error, std::sqrt(1.5 / 2.0));
  EXPECT_DOUBLE_EQ(line.intercept_error, std::sqrt(1.5 * (1.0 / 3.0 + 4.0 / 2.0)));
  EXPECT_DOUBLE_EQ(line.at(4.0), 7.0);
  EXPECT_EQ(line.low_x, 1.0);
  EXPECT_EQ(line.high_x, 3.0);
}

TEST(FittedLine, CannotTellSlopesFromOnePlace) {
  const Line line = fitted_line(std::vector<vec2>{{2.0, 1.0}, {2.0, 2.0}, {2.0, 6.0}});
  EXPECT_EQ(line.slope, 0.0);
  EXPECT_DOUBLE_EQ(line.intercept, 3.0);
  EXPECT_EQ(line.slope_error, std::numeric_limits<double>::infinity());
  EXPECT_EQ(fitted_line({}).count, 0U);
  EXPECT_EQ(fitted_line(std::vector<vec2>{{0.0, 0.0}, {1.0, 1.0}}).slope_error, std::numeric_limits<double>::infinity());
}

// What the design of the model says of Table 1.
TEST(Experiment, TableOneGivesItsLines) {
  ASSERT_EQ(experiment_panes().size(), 19U);
  const Line large = experiment_large_line();
  EXPECT_NEAR(large.slope, 0.0615, 0.00005);
  EXPECT_NEAR(large.intercept, 3.06, 0.005);
  EXPECT_NEAR(large.correlation, 0.947, 0.0005);
  EXPECT_NEAR(large.residual, 1.14, 0.005);
  std::vector<vec2> rings;
  Distribution radial_count;
  for (const ExperimentPane& pane : experiment_panes()) {
    radial_count.add(pane.radial_count);
    // cr_1 and cr_4 are left out, as in the paper.
    const bool far_off = pane.radial_count == 70 || pane.radial_count == 145;
    if (pane.ring_radius_mm && !far_off) rings.emplace_back(pane.radial_count, *pane.ring_radius_mm);
  }
  const Line ring = fitted_line(rings);
  EXPECT_NEAR(ring.slope, ring_radius_slope_mm, 0.0005);
  EXPECT_NEAR(ring.intercept, ring_radius_offset_mm, 0.02);
  EXPECT_NEAR(ring.correlation, 0.994, 0.0005);
  EXPECT_NEAR(radial_count.mean(), 95.7, 0.05);
  EXPECT_NEAR(radial_count.variance() / radial_count.mean(), 29.6, 0.05);
}

TEST(Distribution, TellsMomentsAndRange) {
  Distribution distribution;
  EXPECT_EQ(distribution.deviation(), 0.0);
  for (const double value : {4.0, 1.0, 7.0}) distribution.add(value);
  EXPECT_EQ(distribution.count(), 3U);
  EXPECT_DOUBLE_EQ(distribution.mean(), 4.0);
  EXPECT_DOUBLE_EQ(distribution.variance(), 9.0);
  EXPECT_DOUBLE_EQ(distribution.deviation(), 3.0);
  EXPECT_EQ(distribution.least(), 1.0);
  EXPECT_EQ(distribution.greatest(), 7.0);
}

TEST(Histogram, CountsByCellsThatHoldTheirLowerBound) {
  Histogram histogram{-1.0, 0.5, std::vector<std::size_t>(4)};
  for (const double value : {-1.0, -0.75, -0.5, 0.49, 0.5, 0.99, 1.0, 1e9, -1e9}) histogram.add(value);
  EXPECT_EQ(histogram.counts, (std::vector<std::size_t>{3, 1, 1, 4}));
}

}  // namespace
}  // namespace shatterpave::measure
