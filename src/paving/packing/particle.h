// What a square packing is made of: particles, and the frames in which their distances are measured.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/vec.h"
#include "paving/field/axes.h"

namespace shatterpave::paving {

// The frame of a square, scaled so that a pitch along or across the rows has length 1.
struct Frame {
  vec2 axis{1.0, 0.0};
  vec2 pitch{1.0, 1.0};

  vec2 into(vec2 d) const { return {glm::dot(d, axis) / pitch.x, cross(axis, d) / pitch.y}; }
  vec2 out_of(vec2 q) const { return (q.x * pitch.x) * axis + (q.y * pitch.y) * left_of(axis); }
};

// The centre of a stone to be.
struct Particle {
  vec2 at{0.0, 0.0};    // mm, on the lattice
  vec2 axis{1.0, 0.0};  // unit vector along its row
  double size = 1.0;    // as a part of the stone that is asked for

  Frame frame(vec2 pitch) const { return {axis, size * pitch}; }
};

// How far away `q` is, in pitches, if it is in a frame: that of squares that do not overlap is 1 and more.
inline double largest(vec2 q) { return std::max(std::abs(q.x), std::abs(q.y)); }

// The frame between two places.
inline Frame mean_frame(vec2 a, vec2 b, bool is_cross, vec2 pitch) {
  const vec2 sum = a + turned_like(b, a, is_cross);
  return {sum / std::sqrt(glm::dot(sum, sum)), pitch};
}

// Between two particles: a pitch is half of the one and half of the other.
inline Frame frame_between(const Particle& a, const Particle& b, bool is_cross, vec2 pitch) {
  return mean_frame(a.axis, b.axis, is_cross, (0.5 * (a.size + b.size)) * pitch);
}

}  // namespace shatterpave::paving
