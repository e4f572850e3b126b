#include "measure/count_law.h"

#include "core/functions.h"

namespace shatterpave::measure {

// By the ratio of each probability to the one before, in logarithms: that of 0 may be far below the least number above 0.
std::vector<double> probabilities(const CountLaw& law, int highest) {
  const bool is_poisson = law.dispersion <= 1.0;
  const double size = is_poisson ? 0.0 : law.mean / (law.dispersion - 1.0);
  double log_probability = is_poisson ? -law.mean : -size * logarithm(law.dispersion);
  std::vector<double> result = {exponential(log_probability)};
  for (int k = 1; k <= highest; ++k) {
    const double ratio = is_poisson ? law.mean / k : (k - 1.0 + size) / k * (1.0 - 1.0 / law.dispersion);
    log_probability += logarithm(ratio);
    result.push_back(exponential(log_probability));
  }
  return result;
}

}  // namespace shatterpave::measure
