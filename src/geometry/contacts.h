// Where rings meet that should not: rounding to the lattice may close what was open by less than 1 µm.
#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::geometry {

// The points where sides of one ring or of two meet, other than the common vertices of neighbours. Exact, except that points
// where sides cross are rounded to the lattice.
//   rings  each of three or more vertices, each different from the next one
std::vector<vec2> contacts(const std::vector<Polygon>& rings);

// The regions without squares of 4 µm about their contacts, in the narrowest bays larger ones, so that no ring touches itself
// or another one. Regions without contacts, as most are, stay as they were.
std::vector<Region> parted(std::vector<Region> regions);

// The outlines and the holes.
std::vector<Polygon> rings_of(const std::vector<Region>& regions);

}  // namespace shatterpave::geometry
