// The border course: a row of stones along the outline and holes.
#pragma once

#include <vector>

#include "paving/pavement.h"
#include "paving/tiles/tiling.h"

namespace shatterpave::paving {

// Along the border, across it; mm.
vec2 border_stone_mm(const Pavement& pavement);

// The area in two parts, which touch but for rounding: as far from the border as the course is deep, and nearer.
struct BorderedArea {
  std::vector<geometry::Region> course;
  std::vector<geometry::Region> within;
};
BorderedArea bordered_area(const Pavement& pavement);

// Tiles that cover the course, as `bordered_area` gives it; they may reach beyond it.
std::vector<Tile> border_tiles(const Pavement& pavement, const std::vector<geometry::Region>& course);

}  // namespace shatterpave::paving
