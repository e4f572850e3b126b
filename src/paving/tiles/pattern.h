// A periodic pattern of tiles, repeated over an area.
#pragma once

#include <vector>

#include "core/angle.h"
#include "geometry/region_index.h"
#include "paving/tiles/tiling.h"

namespace shatterpave::paving {

// Tiles in the pattern's own coordinates (u, v), mm, which repeat by `period_mm.x` along `row`, and by `period_mm.y` across it
// while moving on by `shift` (a part of period_mm.x) along it.
struct Pattern {
  vec2 period_mm{1.0, 1.0};  // each > 0
  double shift = 0.0;        // 0 … 1
  std::vector<Tile> tiles;
  vec2 row{1.0, 0.0};  // unit vector
};

// Where a pattern lies: its origin, and the direction of u.
struct Placement {
  vec2 origin{0.0, 0.0};
  vec2 along{1.0, 0.0};  // unit vector

  vec2 out_of(vec2 q) const { return origin + q.x * along + q.y * left_of(along); }
  vec2 direction_of(vec2 q) const { return q.x * along + q.y * left_of(along); }
};

// The lower left corner of the box about the area that is turned to `along`, in the coordinates along and across.
vec2 lowest_corner(const geometry::RegionIndex& area, vec2 along);

// With the origin in that corner, so that whole stones start there.
Placement anchored(const geometry::RegionIndex& area, vec2 along);

// Whether a tile has a point in the area, or nearly.
bool is_needed(const geometry::Polygon& outline, const geometry::RegionIndex& area);

// The tiles of the pattern that have a point in the area, in rows from the origin.
std::vector<Tile> repeated(const Pattern& pattern, const Placement& placement, const geometry::RegionIndex& area);

}  // namespace shatterpave::paving
