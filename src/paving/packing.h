// Square packing (§3 of Miyata and Itoh): particles in the shape of stones, in rows along the direction field.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/region_index.h"
#include "paving/direction_field.h"
#include "paving/pavement.h"

namespace shatterpave::paving {

// The centre of a stone to be.
struct Particle {
  vec2 at{0.0, 0.0};    // mm, on the lattice
  vec2 axis{1.0, 0.0};  // unit vector along its row
};

// From one stone to the next: along the rows, across them (mm). A stone and a joint.
inline vec2 pitch_mm(const Pavement& pavement) { return pavement.stone_mm + vec2{pavement.joint_mm, pavement.joint_mm}; }

// Particles that fill the area, and a band of more than two pitches about it, so that the stones at the border are cut
// from rows that go on beyond it. No two are in one place.
std::vector<Particle> packed_particles(const Pavement& pavement, const geometry::RegionIndex& area, const DirectionField& field,
                                       std::uint64_t seed);

}  // namespace shatterpave::paving
