// Tests of laws: how likely it is that a sample as far from its law comes about by chance.
//
// All such tests together reject a right program in 1 % of all choices of seeds (Šidák); their seeds are fixed, so a failure
// is no bad luck but a change. Beside each stands a twin with a slightly wrong law that must be rejected.
#pragma once

#include <functional>
#include <vector>

namespace shatterpave::support {

// How many tests of laws the project has; raise it with each that is added.
inline constexpr int tests_of_laws = 24;

// The p below which one test rejects: 1 - (1 - 0.01)^(1 / tests_of_laws).
double significance();

// Pearson's chi-square test. `expected` are counts, of the same sum as `observed`; neighbouring cells are joined until each
// expects 5 or more.
double chi_square_p(const std::vector<double>& observed, const std::vector<double>& expected);

// The test of Kolmogorov and Smirnov against a continuous distribution function, by the limit law with Stephens's correction
// for finite samples (J. R. Stat. Soc. B 32, 1970), which is good for 5 values and more.
double kolmogorov_p(std::vector<double> sample, const std::function<double(double)>& distribution);

// The same of two samples: whether they are of one law. Their values must not depend on one another.
double kolmogorov_p(std::vector<double> sample, std::vector<double> other);

}  // namespace shatterpave::support
