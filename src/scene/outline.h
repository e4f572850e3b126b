// Outlines as files give them, into regions on the lattice.
#pragma once

#include <vector>

#include "core/error.h"
#include "geometry/polygon.h"

namespace shatterpave::scene {

// A ring of points as it was given: either winding, the first point repeated at the end or not, and points repeated in
// succession; and its place, for messages.
struct Ring {
  std::vector<vec2> points_mm;
  Place place;
};

// Limits of one outline with its holes, against input that would take all memory.
inline constexpr std::size_t most_vertices = 1'000'000;
inline constexpr std::size_t most_holes = 10'000;

// The region of an outline with holes: points moved to the lattice (to the nearest µm), repeated ones left out, outline
// counter-clockwise and holes clockwise. Throws InputError, at the place of the ring, where the rings make no region; an edge
// has the number of the given point where it starts, from 0.
geometry::Region region_of(const Ring& outline, const std::vector<Ring>& holes);

}  // namespace shatterpave::scene
