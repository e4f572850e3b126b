// How many cracks an impact makes: eq. 3, 5 and 6 of Agui et al. 1992.
#pragma once

#include <cstdint>

#include "core/random.h"
#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

inline constexpr int largest_radial_count = 10000;
inline constexpr int largest_circular_count = 1000;

// M_ave of eq. 5: that of the impact where it is given, else from the ball's energy, reference_radial_count ×
// (energy / energy of a 25 mm ball at 6.26 m/s)^energy_exponent, balls being of one material; within 1 … 10,000.
double mean_radial_count(const Impact& impact, const Growth& growth);

// M, N and R of an impact that `element` identifies. Given counts win; 0 <= N <= M.
ImpactCounts drawn_counts(const Impact& impact, const Growth& growth, std::uint64_t seed, Id element);

// Rand of §4.2: a number about `mean`, within [(1 − z) mean, (1 + z) mean], by the law of `growth`. The normal law is drawn
// again where it leaves the range.
double spread_about(double mean, const Growth& growth, std::uint64_t seed, const Address& address);

}  // namespace shatterpave::glass
