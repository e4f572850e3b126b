// One course of stones along a line.
#pragma once

#include <vector>

#include "paving/tiling.h"

namespace shatterpave::paving {

// Tiles along the closed line `middle` (which may turn either way), pitch.y / 2 to either side of it and about pitch.x long: a
// whole number from one sharp corner to the next, where the joint is a mitre. `phase`, 0 … 1, is where the first perpend after
// a corner stands, as a part of a stone. Where the line bends more tightly than stones can follow there are none; from tiles of
// places where it comes near to itself others may be taken off, see `without_overlaps`.
std::vector<Tile> course_tiles(const geometry::Polygon& middle, vec2 pitch, double phase);

// What each tile leaves of those after it, and they of it: an earlier tile keeps what two have in common.
std::vector<Tile> without_overlaps(std::vector<Tile> tiles, double pitch_mm);

}  // namespace shatterpave::paving
