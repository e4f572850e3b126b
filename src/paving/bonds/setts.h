// What bonds of setts that taper have in common: segmental arcs and fans.
#pragma once

#include "paving/bonds/table.h"

namespace shatterpave::paving {

// Perpends that end this near to one another on a line end in one place.
inline constexpr double same_place_mm = 0.01;

// With deeper ones perpends, which fan out, would meet.
inline constexpr ShapeLimits sett_shapes{0.5, 2.0, "at most twice as long as wide"};

}  // namespace shatterpave::paving
