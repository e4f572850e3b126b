// What a square packing is made of: particles, and the frames in which their distances are measured.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/vec.h"

namespace shatterpave::paving {

// The centre of a stone to be.
struct Particle {
  vec2 at{0.0, 0.0};    // mm, on the lattice
  vec2 axis{1.0, 0.0};  // unit vector along its row
};

// The frame of a square, scaled so that a pitch along or across the rows has length 1.
struct Frame {
  vec2 axis{1.0, 0.0};
  vec2 pitch{1.0, 1.0};

  vec2 into(vec2 d) const { return {glm::dot(d, axis) / pitch.x, cross(axis, d) / pitch.y}; }
  vec2 out_of(vec2 q) const { return (q.x * pitch.x) * axis + (q.y * pitch.y) * left_of(axis); }
};

// How far away `q` is, in pitches, if it is in a frame: that of squares that do not overlap is 1 and more.
inline double largest(vec2 q) { return std::max(std::abs(q.x), std::abs(q.y)); }

// `axis`, turned by quarter or half turns (those of the field's symmetry) to be like `like`.
inline vec2 turned_like(vec2 axis, vec2 like, bool is_cross) {
  const double along = glm::dot(axis, like);
  const double across = cross(axis, like);
  if (is_cross && std::abs(across) > std::abs(along)) return across > 0.0 ? left_of(axis) : -left_of(axis);
  return along < 0.0 ? -axis : axis;
}

// The frame between two places.
inline Frame mean_frame(vec2 a, vec2 b, bool is_cross, vec2 pitch) {
  const vec2 sum = a + turned_like(b, a, is_cross);
  return {sum / std::sqrt(glm::dot(sum, sum)), pitch};
}

}  // namespace shatterpave::paving
