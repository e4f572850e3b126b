#include "glass/growth/counts.h"

#include <algorithm>
#include <cmath>

#include "core/functions.h"

namespace shatterpave::glass {

namespace {

// Gamma of shape `shape` and scale 1: Marsaglia and Tsang, "A simple method for generating gamma variables", ACM TOMS 26
// (2000); for shapes below 1 by their boost of §6.
double gamma_draw(double shape, std::uint64_t seed, Stream stream, Id element) {
  const double d = (shape < 1.0 ? shape + 1.0 : shape) - 1.0 / 3.0;
  const double c = 1.0 / std::sqrt(9.0 * d);
  const double boost = shape < 1.0 ? power(1.0 - uniform(seed, {stream, element.child("boost")}), 1.0 / shape) : 1.0;
  for (std::uint32_t draw = 0;; ++draw) {
    const double x = normal(seed, {stream, element.child("normal"), draw});
    const double v = (1.0 + c * x) * (1.0 + c * x) * (1.0 + c * x);
    if (v <= 0.0) continue;
    const double u = 1.0 - uniform(seed, {stream, element.child("uniform"), draw});
    if (logarithm(u) < 0.5 * x * x + d - d * v + d * logarithm(v)) return d * v * boost;
  }
}

// M of eq. 5. The negative binomial is a Poisson law whose mean is drawn from a gamma law.
int drawn_radial_count(double mean, double dispersion, std::uint64_t seed, Id element) {
  const double excess = dispersion - 1.0;
  const double poisson_mean = excess > 0.0 ? excess * gamma_draw(mean / excess, seed, Stream::radial_count, element) : mean;
  const double limited = std::min(poisson_mean, 2.0 * largest_radial_count);
  return std::clamp(poisson(seed, {Stream::radial_count, element}, limited), 1, largest_radial_count);
}

double rounded(double value, Rounding rounding) {
  switch (rounding) {
    case Rounding::down:
      return std::floor(value);
    case Rounding::up:
      return std::ceil(value);
    case Rounding::nearest:
      break;
  }
  return std::floor(value + 0.5);
}

}  // namespace

double mean_radial_count(const Impact& impact, const Growth& growth) {
  if (impact.mean_radial_count) return *impact.mean_radial_count;
  const Impact experiment;
  const double size = impact.ball_diameter_mm / experiment.ball_diameter_mm;
  const double speed = impact.speed_m_s / experiment.speed_m_s;
  const double energy = size * size * size * speed * speed;
  return std::clamp(growth.reference_radial_count * power(energy, growth.energy_exponent), 1.0,
                    static_cast<double>(largest_radial_count));
}

ImpactCounts drawn_counts(const Impact& impact, const Growth& growth, std::uint64_t seed, Id element) {
  ImpactCounts counts;
  counts.at_mm = impact.at_mm;
  const int m = impact.radial_count
                    ? *impact.radial_count
                    : drawn_radial_count(mean_radial_count(impact, growth), growth.count_dispersion, seed, element);
  const double deviation =
      growth.large_deviation > 0.0 ? growth.large_deviation * normal(seed, {Stream::large_count, element}) : 0.0;
  const double n = rounded(growth.large_slope * m + growth.large_offset + deviation, growth.large_rounding);
  const double r = m > growth.circular_threshold ? std::floor(growth.circular_slope * m + growth.circular_offset) : 0.0;
  counts.radial_count = m;
  counts.large_count = std::clamp(impact.large_count.value_or(static_cast<int>(std::clamp(n, 0.0, 1.0 * m))), 0, m);
  counts.circular_count = impact.circular_count.value_or(static_cast<int>(std::clamp(r, 0.0, 1.0 * largest_circular_count)));
  return counts;
}

double spread_about(double mean, const Growth& growth, std::uint64_t seed, const Address& address) {
  const double reach = growth.spread_limit * mean;
  if (growth.spread == Spread::uniform) return mean + reach * (2.0 * uniform(seed, address) - 1.0);
  // A draw again has an address of its own below that of the first.
  for (std::uint32_t attempt = 0;; ++attempt) {
    const double offset =
        growth.spread_deviation * normal(seed, {address.stream, address.element.child(attempt), address.draw});
    if (std::abs(offset) <= 1.0) return mean + reach * offset;
  }
}

}  // namespace shatterpave::glass
