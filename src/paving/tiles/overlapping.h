// Tiles that lie over one another.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::paving {

// Whether two simple polygons have more in common than a seam of rounding: a corner of one lies in the other, or two of their
// sides cross, farther than `seam_mm` from its border, or from one another's ends.
bool lie_over_one_another(const geometry::Polygon& a, const geometry::Polygon& b, double seam_mm);

// All pairs of which that holds, the lower number first, ascending. Near-linear in the number of tiles.
std::vector<std::pair<std::size_t, std::size_t>> overlapping_pairs(const std::vector<geometry::Polygon>& tiles, double seam_mm);

}  // namespace shatterpave::paving
