// Axes: directions of which half turns, or quarter turns, mean nothing.
#pragma once

#include <cmath>

#include "core/vec.h"

namespace shatterpave::paving {

// `axis`, turned by quarter or half turns (those of the field's symmetry) to be like `like`, of any length but 0.
inline vec2 turned_like(vec2 axis, vec2 like, bool is_cross) {
  const double along = glm::dot(axis, like);
  const double across = cross(axis, like);
  if (is_cross && std::abs(across) > std::abs(along)) return across > 0.0 ? left_of(axis) : -left_of(axis);
  return along < 0.0 ? -axis : axis;
}

}  // namespace shatterpave::paving
