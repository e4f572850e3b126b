// Where a straight segment is nearest to a point.
#pragma once

#include <algorithm>

#include "core/vec.h"

namespace shatterpave::geometry {

// The point of the segment from `a` to `b` that is nearest to `point`; where both ends are one, that one.
inline vec2 nearest_on_segment(vec2 point, vec2 a, vec2 b) {
  const vec2 side = b - a;
  const double squared_length = glm::dot(side, side);
  const double t = squared_length == 0.0 ? 0.0 : std::clamp(glm::dot(point - a, side) / squared_length, 0.0, 1.0);
  return a + t * side;
}

inline double distance_to_segment(vec2 point, vec2 a, vec2 b) { return glm::length(point - nearest_on_segment(point, a, b)); }

}  // namespace shatterpave::geometry
