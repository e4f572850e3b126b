// How a pane breaks: the cracks of its impacts, by its kind of glass.
#pragma once

#include <cstdint>

#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// Throws InputError for an impact that is not strictly inside the outline, for steps of growth that are too short for the pane,
// and for more dice than there may be: what `broken` refuses, known at once.
void require_breakable(const Pane& pane);

// The cracks of `pane`, a pure function of its arguments:
//   annealed   they grow (glass/growth/growth.h)
//   tempered   the borders of its dice (glass/dicing/dice.h)
//   laminated  those of the sheet that is hit, which grow as in annealed glass. Of a pane with shards some run through both
//              sheets, each with the probability that the pane gives
// Where the pane has given cracks, these, of whatever glass it is.
//
// They are all that come to be; where the pane has a time_us, with their times, from which `network_at` (map/growth_clock.h)
// tells what is there by then. Times change nothing else.
//
// All vertices lie in the pane; no two cracks cross; a crack that ends on another ends in a vertex of its polyline; a crack
// that ends at the edge ends within 1 µm of it: exact on the lattice.
//
// REQUIRES the ranges of glass/pane.h. Throws InputError as `require_breakable` does.
CrackNetwork broken(const Pane& pane, std::uint64_t seed);

// The cracks of the far sheet of a pane that breaks as two (glass/sheets.h), which grow about the same impacts by themselves,
// with numbers that follow on those of `near`, the cracks of the other sheet when all have grown. As sound as those; of the two
// sheets' cracks nothing is promised. Without cracks for a pane that is one sheet, or whose far sheet stays whole.
CrackNetwork broken_far_sheet(const Pane& pane, const CrackNetwork& near, std::uint64_t seed);

}  // namespace shatterpave::glass
