#include "support/laws.h"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

#include "core/error.h"

namespace shatterpave::support {

namespace {

// How likely the distance of Kolmogorov and Smirnov is as large for `n` values, by Stephens's correction.
double tail(double distance, double n) {
  const double scaled = distance * (std::sqrt(n) + 0.12 + 0.11 / std::sqrt(n));
  if (scaled < 0.2) return 1.0;  // to 12 digits, where the series hardly converges
  double p = 0.0;
  for (int k = 1; k <= 100; ++k) p += (k % 2 == 1 ? 2.0 : -2.0) * std::exp(-2.0 * k * k * scaled * scaled);
  return std::clamp(p, 0.0, 1.0);
}

}  // namespace

double significance() { return 1.0 - std::pow(0.99, 1.0 / tests_of_laws); }

double chi_square_p(const std::vector<double>& observed, const std::vector<double>& expected) {
  ENSURE(observed.size() == expected.size());
  std::vector<double> counts;
  std::vector<double> laws;
  double count = 0.0;
  double law = 0.0;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    count += observed[i];
    law += expected[i];
    if (law >= 5.0) {
      counts.push_back(count);
      laws.push_back(law);
      count = law = 0.0;
    }
  }
  ENSURE(counts.size() >= 2);
  counts.back() += count;
  laws.back() += law;
  double chi_square = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) chi_square += (counts[i] - laws[i]) * (counts[i] - laws[i]) / laws[i];
  return boost::math::gamma_q(0.5 * static_cast<double>(counts.size() - 1), 0.5 * chi_square);
}

double kolmogorov_p(std::vector<double> sample, const std::function<double(double)>& distribution) {
  ENSURE(sample.size() >= 5);
  std::ranges::sort(sample);
  const auto n = static_cast<double>(sample.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double law = distribution(sample[i]);
    distance = std::max({distance, law - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - law});
  }
  return tail(distance, n);
}

double kolmogorov_p(std::vector<double> sample, std::vector<double> other) {
  ENSURE(sample.size() >= 5 && other.size() >= 5);
  std::ranges::sort(sample);
  std::ranges::sort(other);
  const auto n = static_cast<double>(sample.size());
  const auto m = static_cast<double>(other.size());
  double distance = 0.0;
  for (std::size_t i = 0, j = 0; i < sample.size() && j < other.size();) {
    const double x = std::min(sample[i], other[j]);
    while (i < sample.size() && sample[i] == x) ++i;
    while (j < other.size() && other[j] == x) ++j;
    distance = std::max(distance, std::abs(static_cast<double>(i) / n - static_cast<double>(j) / m));
  }
  return tail(distance, n * m / (n + m));
}

}  // namespace shatterpave::support
