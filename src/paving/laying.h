// Laying of stones: square packing along a direction field (Miyata and Itoh §3, §4), then closed regions with joints.
#pragma once

#include <cstdint>

#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::paving {

// Throws InputError where `pavement` cannot be laid: sizes that mean nothing, shapes that its bond cannot do with, too many
// stones.
void require_layable(const Pavement& pavement);

// The stones of `pavement`, in order of their ids. A pure function of its arguments.
StoneLayout laid_stones(const Pavement& pavement, std::uint64_t seed);

}  // namespace shatterpave::paving
