// The noise along a crack by which its walls lean, bow and open.
#pragma once

#include <cstdint>

#include "core/random.h"

namespace shatterpave::glass {

// In [-1, 1], smooth, a pure function of its arguments; x, along the crack, is in lengths of twist, 0 … 2^29. It keeps to one
// side over long stretches and changes between them unevenly: sides every 2.8 lengths in the mean, now after a half, now after
// ten. It is no steeper than 3 a length. By eye, from photographs.
double crack_wave(std::uint64_t seed, Stream stream, const Id& crack, double x);

}  // namespace shatterpave::glass
