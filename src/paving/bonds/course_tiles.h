// One course of stones along a line.
#pragma once

#include <vector>

#include "paving/tiles/tiling.h"

namespace shatterpave::paving {

// Tiles along the closed line `middle` (which may turn either way), pitch.y / 2 to either side of it and no longer than pitch.x
// along their longer side, but for a tenth of `joint_mm`: a whole number from one sharp corner to the next, where the joint is
// a mitre; the first and the last of them reach farther where the course is deep, and are two stones or more. `phase`, 0 … 1,
// is where the first perpend after a corner stands, as a part of a stone. Where the line bends more tightly than stones can
// follow there are none; where it comes near to itself tiles lie over one another (paving/tiles/filling.h parts them).
std::vector<Tile> course_tiles(const geometry::Polygon& middle, vec2 pitch, double joint_mm, double phase);

}  // namespace shatterpave::paving
