// Steps.
#pragma once

#include <vector>

#include "paving/pavement.h"

namespace shatterpave::paving {

// The steps of `pavement`, which has a flight, from the first row along its direction on, as pavements without a flight: each
// is one row of blocks, whose sides are seen down to the step below it. The flight's `tread_mm` is the depth of a row; what is
// left of the area beyond the last whole one is a narrower step, or, if it is less than a twentieth of one, part of that.
//
// Which row is the first: in one direction the lowest on the left of it; of a radial one the innermost; of guides those on both
// sides of them; of a boundary the outermost. `ground.level_mm` is the ground before the first step, which is a riser higher.
// The area may fall into several parts: then a step is several pavements. All have the name of `pavement`.
//   REQUIRES a riser other than 0; an area without holes where the direction is its boundary
std::vector<Pavement> steps(const Pavement& pavement);

}  // namespace shatterpave::paving
