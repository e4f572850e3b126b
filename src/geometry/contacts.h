// Where rings meet that should not: rounding to the lattice may close what was open by less than 1 µm.
#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::geometry {

// The points in which sides meet, of one ring or of two, but the vertices that neighbours have in common. Exact but for points
// in which sides cross, which are rounded to the lattice.
//   rings  each of three or more vertices, each different from the next one
std::vector<vec2> contacts(const std::vector<Polygon>& rings);

// The regions less squares of 4 µm about their contacts, so that rings touch neither themselves nor one another. Mostly they
// are what was given.
std::vector<Region> parted(std::vector<Region> regions);

// The outlines and the holes.
std::vector<Polygon> rings_of(const std::vector<Region>& regions);

}  // namespace shatterpave::geometry
