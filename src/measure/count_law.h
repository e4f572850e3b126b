// The laws by which the number M of radial cracks of an impact may vary (eq. 5 of Agui et al. 1992, and Table 1).
#pragma once

#include <vector>

namespace shatterpave::measure {

struct CountLaw {
  double mean = 0.0;        // > 0
  double dispersion = 1.0;  // variance / mean: 1 is Poisson, above it negative binomial

  bool operator==(const CountLaw&) const = default;
};

// The probabilities of 0, 1 … `highest`.
std::vector<double> probabilities(const CountLaw& law, int highest);

}  // namespace shatterpave::measure
