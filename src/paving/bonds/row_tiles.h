// Bonds that are rows and nothing else: straight, in rings, or along a line.
#pragma once

#include "geometry/region_index.h"
#include "paving/pavement.h"
#include "paving/tiles/pattern.h"

namespace shatterpave::paving {

// Straight rows that are shifted by `offset` of a stone each, 0 … 1; mm.
Pattern rows_pattern(vec2 pitch, double offset);

// The same along the pavement's direction, over all of the area: rings (rings.h), rows along a line (courses.h) or straight
// rows. The first is shifted by `Bonding::start`.
std::vector<Tile> row_tiles(const Pavement& pavement, double offset, const geometry::RegionIndex& area);

}  // namespace shatterpave::paving
