#include "support/laws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace shatterpave::support {
namespace {

TEST(Laws, ChiSquareAgreesWithTables) {
  // 3.841 is the 95th percentile of chi-square with one degree of freedom: 50 ± 9.8 of 100 fair coins.
  EXPECT_NEAR(chi_square_p({59.8, 40.2}, {50.0, 50.0}), 0.05, 1e-3);
  // 18.307 is the 95th percentile with ten.
  std::vector<double> observed(11, 100.0);
  observed[0] += std::sqrt(18.307 * 100.0 / 2.0);
  observed[1] -= std::sqrt(18.307 * 100.0 / 2.0);
  EXPECT_NEAR(chi_square_p(observed, std::vector<double>(11, 100.0)), 0.05, 1e-4);
}

TEST(Laws, ChiSquareJoinsSmallCells) {
  // Cells of 2 + 3, 5 and 4 + 1 + 1, of which the last two join the one before.
  EXPECT_DOUBLE_EQ(chi_square_p({5, 0, 5, 4, 1, 1}, {2, 3, 5, 4, 1, 1}), 1.0);
}

TEST(Laws, KolmogorovAgreesWithTables) {
  // For n = 100 the 5 % point of the distance is 0.13403 (Miller 1956): a sample moved by that much off its places.
  std::vector<double> sample;
  sample.reserve(100);
  for (int i = 0; i < 100; ++i) sample.push_back((i + 1) / 100.0 - 0.13403);
  EXPECT_NEAR(kolmogorov_p(sample, [](double x) { return std::clamp(x, 0.0, 1.0); }), 0.05, 2e-3);
}

TEST(Laws, KolmogorovOfTwoSamplesAgreesWithTables) {
  // For two samples of 100 the 5 % point of the distance is 1.358 sqrt(2 / 100) = 0.192 (Smirnov 1948).
  std::vector<double> sample;
  std::vector<double> moved;
  for (int i = 0; i < 100; ++i) {
    sample.push_back(i);
    moved.push_back(i < 19 ? 1000.0 : i);
  }
  EXPECT_NEAR(kolmogorov_p(sample, moved), 0.05, 0.01);
  EXPECT_EQ(kolmogorov_p(sample, sample), 1.0);
}

}  // namespace
}  // namespace shatterpave::support
