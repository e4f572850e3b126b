// Pieces too small to be stones of their own become parts of their neighbours.
#pragma once

#include <vector>

#include "paving/cutting.h"

namespace shatterpave::paving {

// `pieces` of `cells`, in the same order, without those whose face is smaller than `least_piece` of a whole one and that touch
// another: they are joined to what they touch, smallest first.
std::vector<Piece> without_small(std::vector<Piece> pieces, const Cells& cells, const StoneSize& size);

}  // namespace shatterpave::paving
