// Rows in circles.
#pragma once

#include "geometry/region_index.h"
#include "paving/tiling.h"

namespace shatterpave::paving {

// Rings of one depth, pitch.y, about `centre`, each of a whole number of stones about pitch.x long. `offset` as in running
// bond.
std::vector<Tile> ring_tiles(vec2 pitch, vec2 centre, double offset, const geometry::RegionIndex& area);

}  // namespace shatterpave::paving
