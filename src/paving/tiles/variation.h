// Stones as they lie, not as they were set out.
#pragma once

#include <cstdint>
#include <vector>

#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::paving {

// The layout with each stone larger or smaller, turned and moved as it draws by its id, and without the missing ones, whose ids
// stay unused. Faces were a joint apart and half a joint from the border, but for sides that stray into the joint by `bulge` of
// it at most (0 … 0.5). Each corner moves by less than what is left of half the joint: so they stay apart and within the area.
// Where stones are laid by hand (paving/tiles/hand_stones.h), corners take what is left of that room, and missing ones are
// told.
// Stones that are `held`, by index, are no joint apart from all others, and no corner of theirs moves outwards; empty: none is.
StoneLayout varied(StoneLayout layout, const std::vector<bool>& held, const Pavement& pavement, double bulge,
                   std::uint64_t seed);

}  // namespace shatterpave::paving
