// Boxes as polygons.
#pragma once

#include <array>

#include "geometry/polygon.h"

namespace shatterpave::geometry {

// Counter-clockwise from the lower left.
inline std::array<vec2, 4> corners(const Box& box) {
  return {box.low, vec2{box.high.x, box.low.y}, box.high, vec2{box.low.x, box.high.y}};
}

inline Polygon rectangle(const Box& box) { return {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}; }

}  // namespace shatterpave::geometry
