// The widest disc that fits in a region.
#pragma once

#include "geometry/polygon.h"

namespace shatterpave::geometry {

struct Circle {
  vec2 middle{0.0, 0.0};
  double radius = 0.0;
};

// The largest circle in `region`, to `circle_tolerance_mm` in radius; radius 0 if there is no room. Rings may touch and, by
// rounding, cross by a few µm; holes may reach the outline. In O(n log n) for n vertices, which lie within ±1 km.
inline constexpr double circle_tolerance_mm = 0.01;
Circle inscribed_circle(const Region& region);

}  // namespace shatterpave::geometry
