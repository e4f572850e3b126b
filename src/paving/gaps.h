// What tiles leave of a region.
#pragma once

#include <vector>

#include "geometry/region_index.h"
#include "paving/tiling.h"

namespace shatterpave::paving {

// Tiles for what `tiles` leave of `region`, of which `index` is made: none much longer than a stone, none a mere sliver.
std::vector<Tile> gap_tiles(const std::vector<Tile>& tiles, const geometry::Region& region, const geometry::RegionIndex& index,
                            vec2 pitch);

}  // namespace shatterpave::paving
