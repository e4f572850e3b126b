// Stones as they lie, not as they were set out.
#pragma once

#include <cstdint>

#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::paving {

// The layout with each stone larger or smaller, turned and moved as it draws by its id, and without the missing ones, whose ids
// stay unused. Each corner moves by less than half the joint: faces, which were a joint apart and half a joint from the border,
// stay apart and within the area.
StoneLayout varied(StoneLayout layout, const Pavement& pavement, std::uint64_t seed);

}  // namespace shatterpave::paving
