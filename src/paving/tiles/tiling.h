// Stones-to-be as a bond sets them out, half a joint wider all round than the stones.
#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "paving/tiles/cells.h"

namespace shatterpave::paving {

struct Tile {
  geometry::Polygon outline_mm;  // counter-clockwise, simple
  vec2 axis{1.0, 0.0};           // unit vector along the stone
  bool cut = false;              // it is a part of a stone, where rows meet or a course ends
};

// The tiles as cells, in the same order, with corners on the lattice, each cell with its own; who lies beside whom is not told.
// Tiles touch but do not overlap, but for rounding to the lattice.
Cells cells_of(const std::vector<Tile>& tiles);

}  // namespace shatterpave::paving
