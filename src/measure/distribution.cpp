#include "measure/distribution.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace shatterpave::measure {

// Welford, "Note on a method for calculating corrected sums of squares and products", Technometrics 4 (1962).
void Distribution::add(double value) {
  least_ = count_ == 0 ? value : std::min(least_, value);
  greatest_ = count_ == 0 ? value : std::max(greatest_, value);
  ++count_;
  const double off = value - mean_;
  mean_ += off / static_cast<double>(count_);
  squares_ += off * (value - mean_);
}

double Distribution::variance() const { return count_ < 2 ? 0.0 : squares_ / static_cast<double>(count_ - 1); }

double Distribution::deviation() const { return std::sqrt(variance()); }

double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

void Histogram::add(double value) {
  ENSURE(!counts.empty() && width > 0.0);
  const double cell = std::clamp(std::floor((value - low) / width), 0.0, static_cast<double>(counts.size() - 1));
  ++counts[static_cast<std::size_t>(cell)];
}

}  // namespace shatterpave::measure
