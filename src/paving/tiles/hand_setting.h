// Tiles as a hand sets them out, not as they were drawn: rows and lengths differ from one to the next.
#pragma once

#include <cstdint>
#include <vector>

#include "core/random.h"
#include "paving/pavement.h"
#include "paving/tiles/stock.h"
#include "paving/tiles/tiling.h"

namespace shatterpave::paving {

// The tiles with the lines between them moved aside, so that stones differ in length and width; joints keep their width.
//   tiles   touch but do not overlap, but for rounding to the lattice
//   amount  0 … 1; 0 gives them back as they are
// They touch as before, and cover the same: the same points are on the rim of all, and no tile moves one that it does not share
// to the bit with those beside it. None is turned over, lies over another, or is smaller than a third of what it was. Each line
// draws from `seed` and the place where it lies.
std::vector<Tile> hand_set(std::vector<Tile> tiles, double amount, std::uint64_t seed, Id pavement);

// The same for cells, of which bends between shared corners are told; the result tells of none.
Cells hand_set(const Cells& cells, double amount, std::uint64_t seed, Id pavement);

// What stones that are laid by hand are cut from, where others are cut from `stock`.
Stock hand_stock(Stock stock, double joint_mm, double amount);

}  // namespace shatterpave::paving
