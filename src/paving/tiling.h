// Stones-to-be as a bond sets them out, half a joint wider all round than the stones, and their neighbourhood.
#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "paving/cells.h"

namespace shatterpave::paving {

struct Tile {
  geometry::Polygon outline_mm;  // counter-clockwise, simple
  vec2 axis{1.0, 0.0};           // unit vector along the stone
};

// The tiles as cells, in the same order, with corners on the lattice. Tiles touch but do not overlap, but for rounding to the
// lattice. Where a corner of one lies on a straight side of another (a T) it is a corner of both, left out of the outline of
// the second. A side without a tile beyond it has its own cell as neighbour.
Cells cells_of(const std::vector<Tile>& tiles);

}  // namespace shatterpave::paving
