#include "measure/count_law.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shatterpave::measure {
namespace {

TEST(CountLaw, IsPoissonOrNegativeBinomial) {
  // By hand: e^-2 2^3 / 3!; of a negative binomial law with r = 2 and p = 1/2, mean 2 and variance 4, 4 choose 3 / 2^5.
  EXPECT_NEAR(probabilities({2.0, 1.0}, 3)[3], std::exp(-2.0) * 8.0 / 6.0, 1e-15);
  EXPECT_NEAR(probabilities({2.0, 2.0}, 3)[3], 4.0 / 32.0, 1e-15);
}

TEST(CountLaw, HasItsMeanAndVariance) {
  for (const CountLaw& law : {CountLaw{95.7, 1.0}, CountLaw{95.7, 29.6}, CountLaw{2000.0, 1.0}, CountLaw{1.5, 40.0}}) {
    double sum = 0.0;
    double mean = 0.0;
    double square = 0.0;
    const std::vector<double> p = probabilities(law, 5000);
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double count = static_cast<double>(k);
      sum += p[k];
      mean += count * p[k];
      square += count * count * p[k];
    }
    EXPECT_NEAR(sum, 1.0, 1e-9);
    EXPECT_NEAR(mean / law.mean, 1.0, 1e-9);
    EXPECT_NEAR((square - mean * mean) / mean / law.dispersion, 1.0, 1e-6);
  }
}

}  // namespace
}  // namespace shatterpave::measure
