// Rows in circles.
#pragma once

#include "geometry/region_index.h"
#include "paving/pavement.h"
#include "paving/tiles/tiling.h"

namespace shatterpave::paving {

// Rings of one depth, pitch.y, from the first circle on, each of a whole number of stones about pitch.x long. The first has
// is shifted by `start` of a stone, each next one by `offset` more.
std::vector<Tile> ring_tiles(vec2 pitch, const RadialDirection& direction, double start, double offset,
                             const geometry::RegionIndex& area);

}  // namespace shatterpave::paving
