// Which of the user's own colours each stone has.
#pragma once

#include <cstdint>

#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::paving {

// Sets `Stone::colour` where the pavement has colours of its own; else leaves all as it is. Of the stones each colour has its
// share, but for one stone (without a gradient two): so of more than four hundred within half a per cent. Without a gradient or
// attractors that holds also for any run of stones along a curve that fills the plane, so colours are mixed evenly.
//   REQUIRES as many shares as colours, each > 0, 1 together but for rounding
void colour(StoneLayout& layout, const Pavement& pavement, std::uint64_t seed);

}  // namespace shatterpave::paving
