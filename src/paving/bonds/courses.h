// Rows that follow a line: the outline and holes, or guides.
#pragma once

#include "geometry/region_index.h"
#include "paving/pavement.h"
#include "paving/tiles/tiling.h"

namespace shatterpave::paving {

// Guides, straight on beyond their ends until they are out of sight of the box.
std::vector<std::vector<vec2>> extended_guides(const GuidesDirection& direction, const geometry::Box& box);

// Rows of one depth, pitch.y, parallel to the outline and holes of the area (boundary) or to the guides, which run in a joint
// and are taken to go straight on beyond their ends. `offset` as in running bond.
std::vector<Tile> parallel_tiles(const Pavement& pavement, vec2 pitch, double offset, const geometry::RegionIndex& area);

}  // namespace shatterpave::paving
