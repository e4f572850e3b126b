// The middle lines of figures.
#pragma once

#include "trace/picture.h"

namespace shatterpave::trace {

// The figures of the mask thinned to lines a pixel wide, connected as they are: T. Y. Zhang, C. Y. Suen, "A fast parallel
// algorithm for thinning digital patterns", Comm. ACM 27 (1984). Time goes with the pixels of the figures times their width.
Mask skeleton(const Mask& mask);

}  // namespace shatterpave::trace
