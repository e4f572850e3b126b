// Polygons as few convex ones that cover them: what collides for a shard.
#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::glass {

// Convex polygons, counter-clockwise, that cover the region, holes too where they are small. Together they are larger than it
// by at most `excess` of their own area each, and `excess_mm2`.
//   excess, excess_mm2 >= 0
std::vector<geometry::Polygon> convex_parts(const geometry::Region& region, double excess, double excess_mm2);

}  // namespace shatterpave::glass
