// Square packing (§3 of Miyata and Itoh): particles in the shape of stones, in rows along the direction field.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/region_index.h"
#include "paving/field/direction_field.h"
#include "paving/field/size_field.h"
#include "paving/packing/particle.h"
#include "paving/pavement.h"

namespace shatterpave::paving {

// Particles that fill the area, and a band of more than two pitches about it, so that the stones at the border are cut
// from rows that go on beyond it. No two are in one place. `sizes` tells how large each is.
std::vector<Particle> packed_particles(const Pavement& pavement, const geometry::RegionIndex& area, const DirectionField& field,
                                       const SizeField& sizes, std::uint64_t seed);

}  // namespace shatterpave::paving
