// Pieces too small to be stones of their own become parts of their neighbours.
#pragma once

#include <vector>

#include "paving/tiles/cutting.h"

namespace shatterpave::paving {

// `pieces` without those whose face is smaller than `least_piece` of a whole one, where they can be joined to what they touch,
// smallest first: the order stays, and halves of stones that were cut anew are at the end. A small piece is left where no stone
// that fits the stock can be made of it and its neighbours.
std::vector<Piece> without_small(std::vector<Piece> pieces, const StoneSize& size);

}  // namespace shatterpave::paving
