#include "glass/growth/counts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/functions.h"
#include "glass/presets.h"
#include "measure/count_law.h"
#include "measure/experiment.h"
#include "support/laws.h"

namespace shatterpave::glass {
namespace {

ImpactCounts counts_of(int m, Rounding rounding) {
  Impact impact;
  impact.radial_count = m;
  Growth growth;
  growth.large_rounding = rounding;
  growth.large_deviation = 0.0;  // eq. 6 alone
  return drawn_counts(impact, growth, 1, Id("impact"));
}

std::vector<double> radial_counts(int draws, double mean, double dispersion) {
  Impact impact;
  impact.mean_radial_count = mean;
  Growth growth;
  growth.count_dispersion = dispersion;
  std::vector<double> counts;
  counts.reserve(static_cast<std::size_t>(draws));
  for (int i = 0; i < draws; ++i) {
    counts.push_back(drawn_counts(impact, growth, 11, Id("impact").child(static_cast<std::uint64_t>(i))).radial_count);
  }
  return counts;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

double variance_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double sum = 0.0;
  for (const double v : values) sum += (v - mean) * (v - mean);
  return sum / static_cast<double>(values.size() - 1);
}

double poisson_p(const std::vector<double>& sample, double mean) {
  std::vector<double> observed(60, 0.0);
  std::vector<double> expected;
  for (const double m : sample) observed[static_cast<std::size_t>(std::min(m, 59.0))] += 1.0;
  double probability = exponential(-mean);
  for (int k = 0; k < 60; ++k) {
    expected.push_back(probability * static_cast<double>(sample.size()));
    probability *= mean / (k + 1);
  }
  return support::chi_square_p(observed, expected);
}

// Eq. 3 with the constants of Growth, against all twelve printed R; eq. 6 against the printed N: those of Figs. 14 and 15
// follow from rounding up, those of Fig. 16 some from the one, some from the other.
TEST(Counts, FollowThePrintedOnes) {
  for (const Preset& preset : presets()) {
    EXPECT_EQ(counts_of(preset.radial_count, Rounding::up).circular_count, preset.circular_count) << preset.name;
    const int up = counts_of(preset.radial_count, Rounding::up).large_count;
    const int down = counts_of(preset.radial_count, Rounding::down).large_count;
    EXPECT_TRUE(preset.large_count == up || preset.large_count == down) << preset.name;
    if (preset.growth.spread == Spread::normal) {
      EXPECT_EQ(up, preset.large_count) << preset.name;
    }
  }
}

TEST(Counts, RoundEquationSixEachWay) {
  // 0.0606 × 49 + 3.293 = 6.2624, 0.0606 × 95 + 3.293 = 9.05, 0.0606 × 105 + 3.293 = 9.656
  EXPECT_EQ(counts_of(49, Rounding::down).large_count, 6);
  EXPECT_EQ(counts_of(49, Rounding::nearest).large_count, 6);
  EXPECT_EQ(counts_of(49, Rounding::up).large_count, 7);
  EXPECT_EQ(counts_of(95, Rounding::nearest).large_count, 9);
  EXPECT_EQ(counts_of(105, Rounding::nearest).large_count, 10);
}

TEST(Counts, HaveNoRingsUpToTheThreshold) {
  EXPECT_EQ(counts_of(70, Rounding::nearest).circular_count, 0);
  EXPECT_EQ(counts_of(71, Rounding::nearest).circular_count, 4);
}

TEST(Counts, GivenOnesWinAndNeverExceedTheRadials) {
  Impact impact;
  impact.radial_count = 2;
  EXPECT_EQ(drawn_counts(impact, {}, 1, Id("x")).large_count, 2);
  impact.large_count = 0;
  impact.circular_count = 9;
  const ImpactCounts counts = drawn_counts(impact, {}, 1, Id("x"));
  EXPECT_EQ(counts.large_count, 0);
  EXPECT_EQ(counts.circular_count, 9);
}

TEST(Counts, MeanFollowsTheEnergyOfTheBall) {
  Impact impact;
  Growth growth;
  EXPECT_DOUBLE_EQ(mean_radial_count(impact, growth), 95.7);
  impact.speed_m_s *= 4.0;
  EXPECT_NEAR(mean_radial_count(impact, growth), 2.0 * 95.7, 1e-9);  // the square root of the speed
  growth.energy_exponent = 1.0;
  EXPECT_NEAR(mean_radial_count(impact, growth), 16.0 * 95.7, 1e-9);
  impact.mean_radial_count = 12.0;
  EXPECT_EQ(mean_radial_count(impact, growth), 12.0);
}

TEST(Counts, RadialsArePoisson) {
  EXPECT_GT(poisson_p(radial_counts(4000, 24.0, 1.0), 24.0), support::significance());
  // The twin: a little too wide a law.
  EXPECT_LT(poisson_p(radial_counts(4000, 24.0, 1.2), 24.0), support::significance());
}

TEST(Counts, RadialsAreAsDispersedAsAsked) {
  const std::vector<double> counts = radial_counts(20000, 95.7, 29.6);
  EXPECT_NEAR(mean_of(counts), 95.7, 5.0 * std::sqrt(95.7 * 29.6 / 20000.0));
  EXPECT_NEAR(variance_of(counts) / mean_of(counts), 29.6, 2.0);
}

constexpr int last_count = 999;

double chi_square_of(const std::vector<double>& sample, const std::vector<double>& probabilities) {
  std::vector<double> observed(probabilities.size(), 0.0);
  std::vector<double> expected;
  for (const double m : sample) observed[static_cast<std::size_t>(std::min<double>(m, last_count))] += 1.0;
  expected.reserve(probabilities.size());
  for (const double p : probabilities) expected.push_back(p * static_cast<double>(sample.size()));
  return support::chi_square_p(observed, expected);
}

TEST(Counts, RadialsAreNegativeBinomialWhereAsked) {
  const std::vector<double> counts = radial_counts(4000, 95.7, table_1_dispersion);
  EXPECT_GT(chi_square_of(counts, measure::probabilities({95.7, table_1_dispersion}, last_count)), support::significance());
  // The twins: three quarters of that dispersion, and a mean that is off by 10 %.
  EXPECT_LT(chi_square_of(counts, measure::probabilities({95.7, 22.0}, last_count)), support::significance());
  EXPECT_LT(chi_square_of(counts, measure::probabilities({105.3, table_1_dispersion}, last_count)), support::significance());
}

// The nineteen panes of Table 1 cannot have come by a Poisson law; by the negative binomial one of their moments they can.
TEST(Counts, OfTable1AreOverdispersed) {
  std::vector<double> panes;
  for (const measure::ExperimentPane& pane : measure::experiment_panes()) panes.push_back(pane.radial_count);
  EXPECT_NEAR(mean_of(panes), 95.7, 0.05);
  EXPECT_NEAR(variance_of(panes) / mean_of(panes), table_1_dispersion, 0.05);
  const auto by = [&](const std::vector<double>& probabilities) {
    return support::kolmogorov_p(panes, [&](double m) {
      return std::accumulate(probabilities.begin(), probabilities.begin() + static_cast<int>(m) + 1, 0.0);
    });
  };
  EXPECT_GT(by(measure::probabilities({95.7, table_1_dispersion}, last_count)), support::significance());
  EXPECT_LT(by(measure::probabilities({95.7, 1.0}, last_count)), support::significance());
}

// Where the law is all tail: most draws are 0, which is none at all, so 1; and none exceeds the limit.
TEST(Counts, StayInRangeAtAnyDispersion) {
  for (const double mean : {1.0, 3.0, 95.7, 10000.0}) {
    for (const double dispersion : {1.0, 1.0 + 1e-9, 2.0, 1000.0}) {
      const std::vector<double> counts = radial_counts(300, mean, dispersion);
      EXPECT_GE(std::ranges::min(counts), 1.0) << mean << " " << dispersion;
      EXPECT_LE(std::ranges::max(counts), static_cast<double>(largest_radial_count)) << mean << " " << dispersion;
    }
  }
  EXPECT_GT(std::ranges::count(radial_counts(300, 1.0, 1000.0), 1.0), 270);
  EXPECT_NEAR(mean_of(radial_counts(4000, 3000.0, 1000.0)), 3000.0, 5.0 * std::sqrt(3000.0 * 1000.0 / 4000.0));
  EXPECT_NEAR(mean_of(radial_counts(4000, 95.7, 1.0 + 1e-9)), 95.7, 5.0 * std::sqrt(95.7 / 4000.0));
}

// The law that `spread_about` follows: normal, cut at its limits.
double cut_normal(double offset, double deviation) {
  const auto phi = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
  const double tail = phi(-1.0 / deviation);
  return (phi(offset / deviation) - tail) / (1.0 - 2.0 * tail);
}

TEST(Spread, IsTheCutNormalLaw) {
  const Growth growth;
  std::vector<double> offsets;
  for (std::uint32_t i = 0; i < 6000; ++i) {
    const double x = spread_about(40.0, growth, 3, {Stream::large_speed, Id("x").child(i)});
    offsets.push_back((x / 40.0 - 1.0) / 0.3);
  }
  EXPECT_LE(std::ranges::max(offsets), 1.0 + 1e-12);
  EXPECT_GE(std::ranges::min(offsets), -1.0 - 1e-12);
  EXPECT_GT(support::kolmogorov_p(offsets, [](double x) { return cut_normal(x, 1.0 / 3.0); }), support::significance());
  EXPECT_LT(support::kolmogorov_p(offsets, [](double x) { return cut_normal(x, 0.4); }), support::significance());
}

TEST(Spread, IsUniformWhereAsked) {
  Growth growth;
  growth.spread = Spread::uniform;
  std::vector<double> values;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    values.push_back(spread_about(10.0, growth, 3, {Stream::radial_speed, Id("x").child(i)}));
  }
  EXPECT_GT(support::kolmogorov_p(values, [](double x) { return std::clamp((x - 7.0) / 6.0, 0.0, 1.0); }),
            support::significance());
  EXPECT_LT(support::kolmogorov_p(values, [](double x) { return cut_normal((x / 10.0 - 1.0) / 0.3, 0.9); }),
            support::significance());
}

}  // namespace
}  // namespace shatterpave::glass
