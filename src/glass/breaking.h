// How a pane breaks: the cracks of its impacts, by its kind of glass.
#pragma once

#include <cstdint>

#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// The cracks of `pane`, a pure function of its arguments:
//   annealed   they grow (glass/growth/growth.h)
//   tempered   the borders of its dice (glass/dicing/dice.h)
//   laminated  they grow as in annealed glass; some run through both sheets, each with the probability that the pane gives
//
// All vertices lie in the pane; no two cracks cross; a crack that ends on another ends in a vertex of its polyline; a crack
// that ends at the edge ends within 1 µm of it: exact on the lattice.
//
// REQUIRES the ranges of glass/pane.h. Throws InputError for an impact that is not strictly inside the outline, and what growth
// and dicing throw.
CrackNetwork broken(const Pane& pane, std::uint64_t seed);

}  // namespace shatterpave::glass
