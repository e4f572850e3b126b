#pragma once

#include "geometry/polygon.h"

namespace shatterpave::geometry {

// The smallest convex polygon about `polygon`, which has three or more vertices: counter-clockwise, without collinear ones.
Polygon convex_hull(const Polygon& polygon);

}  // namespace shatterpave::geometry
