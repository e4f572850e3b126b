// Areas that the tests of paving share; mm.
#pragma once

#include "geometry/polygon.h"
#include "paving/pavement.h"

namespace shatterpave::paving {

// The area of the contract's example: 4000 × 1200 with a triangular hole.
geometry::Region path_area();
// The quarter annulus of the benchmark, radii 4 m and 10 m about the origin.
geometry::Region quarter_annulus();
// Seven corners, one of them inwards, and a round hole.
geometry::Region concave_area();
// A circle as a polygon.
geometry::Polygon circle(vec2 centre, double radius_mm, int corners);

Pavement pavement(geometry::Region area, double stone_mm, double joint_mm, Direction direction);

// Rows along x, turned by `degrees`.
inline Direction straight(double degrees) { return ConstantDirection{Angle::degrees(degrees)}; }

}  // namespace shatterpave::paving
