// Lens-shaped chips where cracks meet and bend.
#pragma once

#include <cstdint>
#include <span>

#include "glass/growth/ring_pieces.h"
#include "glass/map/crack_map.h"

namespace shatterpave::glass {

// Adds to the map the borders of flakes beside the radials, each an arc (CrackKind::chip) from a vertex in which the radial
// kinks or is met to another place on it. They are shallow: none runs through the glass.
// A flake comes off, at a speed, once the radial has gone by.
//   radials  cracks of the map that have come to their end
//   centre   of their impact
void lay_chips(std::span<const int> radials, const RingCentre& centre, double speed_mm_us, std::uint64_t seed, CrackMap& map);

}  // namespace shatterpave::glass
