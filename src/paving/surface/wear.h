// Where a pavement is walked on, and where its stones were sawn.
#pragma once

#include <vector>

#include "geometry/region_index.h"
#include "paving/stones.h"
#include "paving/surface/stone_body.h"

namespace shatterpave::paving {

// For each stone the traffic over it: from 0 at the border of the area to 1 at the stone farthest from it, smoothly.
std::vector<double> traffic(const std::vector<Stone>& stones, const geometry::RegionIndex& area);

// Sides of a cut stone that lie along the border of the area, where it was cut. `area` is that of the pavement, and is kept.
IsSawn sawn_sides(const Stone& stone, const Pavement& pavement, const geometry::RegionIndex& area);

}  // namespace shatterpave::paving
