// Growth of cracks in a pane: the probability model of Agui et al. 1992 (§3.2, §4).
#pragma once

#include <cstdint>

#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// The cracks of `pane`. Impacts happen in their order; cracks of a later one stop at those of an earlier one. A pure function
// of its arguments: draws are addressed by the pane's name, the impact's index and the crack's place.
CrackNetwork grown_cracks(const Pane& pane, std::uint64_t seed);

}  // namespace shatterpave::glass
