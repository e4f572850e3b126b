// Laying of stones: square packing along a direction field (Miyata and Itoh §3, §4), then closed regions with joints.
#pragma once

#include <cstdint>

#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::paving {

// Throws InputError if `pavement` cannot be laid: because sizes mean nothing, its bond cannot use such stones, or there would
// be too many of them.
void require_layable(const Pavement& pavement);

// The stones of `pavement`, in order of their ids. A pure function of its arguments.
StoneLayout laid_stones(const Pavement& pavement, std::uint64_t seed);

}  // namespace shatterpave::paving
