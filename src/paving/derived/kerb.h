// Kerb stones.
#pragma once

#include "paving/pavement.h"

namespace shatterpave::paving {

// The kerb of `pavement`, which has one, as a pavement of its own: a strip of the kerb's width about the outline, outside, laid
// with one row of long stones with chamfered arrises. Its faces lie `height_mm` above those of the pavement's stones, its
// joints reach down to their bed, and it falls as they do. Its textures are of its whole area, also where those of the pavement
// are seamless.
Pavement kerb(const Pavement& pavement);

}  // namespace shatterpave::paving
