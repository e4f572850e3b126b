// Points of a regular grid that lie in a region or near it, found without visiting the others. The points are not kept: indices
// of points are geometry/point_index.h and paving/packing/near_index.h.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "geometry/region_index.h"

namespace shatterpave::paving {

// The points origin + i·along + j·across for whole i, j; `along` and `across` are perpendicular.
struct Grid {
  vec2 origin{0.0, 0.0};
  vec2 along{1.0, 0.0};
  vec2 across{0.0, 1.0};

  vec2 at(std::int64_t i, std::int64_t j) const {
    return origin + static_cast<double>(i) * along + static_cast<double>(j) * across;
  }
};

struct GridPoint {
  std::int64_t j = 0;  // before i, so that the order is row by row
  std::int64_t i = 0;

  auto operator<=>(const GridPoint&) const = default;
};

// All points of `grid` inside `area` or within `band_mm` of its border, row by row.
std::vector<GridPoint> near_points(const Grid& grid, const geometry::RegionIndex& area, double band_mm);

}  // namespace shatterpave::paving
