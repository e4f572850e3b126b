// Lat-long pictures of all around as a lens sees them that is focused on something near.
#pragma once

#include "core/angle.h"
#include "relief/raster.h"

namespace shatterpave::relief {

inline constexpr Angle widest_blur = Angle::degrees(60.0);

// A lat-long picture (twice as wide as high) in which each direction holds the mean over the disc of that diameter about it, as
// seen on the sphere: points of light become discs, poles are as good as any place, and the light from all around stays the
// same but for what pixels cannot hold. `diameter` within 0 … `widest_blur`; 0 gives the picture itself. Else the result has
// the pixels that a disc needs to look round, at most 4096 across or as many as `sharp` has: wide discs make small pictures,
// narrow ones of small pictures larger ones. The same to the bit for any number of threads.
Raster out_of_focus(const Raster& sharp, Angle diameter);

}  // namespace shatterpave::relief
