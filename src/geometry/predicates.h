// Decisions about points of the lattice, exact by 128-bit integers.
#pragma once

#include "geometry/lattice.h"

namespace shatterpave::geometry {

enum class Side { right = -1, on = 0, left = 1 };

// The side of the directed line a → b on which c lies.
Side side(LatticePoint a, LatticePoint b, LatticePoint c);

// Whether c lies on the closed segment from a to b.
bool on_segment(LatticePoint a, LatticePoint b, LatticePoint c);

// Whether the closed segments have a point in common.
bool segments_meet(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d);

// Whether the segments cross properly: one point in common, inside both.
bool segments_cross(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d);

}  // namespace shatterpave::geometry
