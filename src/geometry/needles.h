// Corners so sharp that their two sides run together on the lattice long before they meet.
#pragma once

#include "geometry/polygon.h"

namespace shatterpave::geometry {

// The region less 2 µm about the sides of each needle that reaches into it: a tip of a hole, or a notch, of less than 0.001
// rad. Cut across, such a tip would vanish, and what is cut would lie over it. The region itself where there is none, or where
// less of it would fall apart.
Region without_needles(const Region& region);

}  // namespace shatterpave::geometry
