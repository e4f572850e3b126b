// Where a packing starts: particles that already stand in rows and columns along the direction field.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "paving/packing.h"

namespace shatterpave::paving {

// The frame of a square, scaled so that a pitch along or across the rows has length 1.
struct Frame {
  vec2 axis{1.0, 0.0};
  vec2 pitch{1.0, 1.0};

  vec2 into(vec2 d) const { return {glm::dot(d, axis) / pitch.x, cross(axis, d) / pitch.y}; }
  vec2 out_of(vec2 q) const { return (q.x * pitch.x) * axis + (q.y * pitch.y) * left_of(axis); }
};

// How far away `q` is, in pitches, if it is in a frame: that of squares that do not overlap is 1 and more.
inline double largest(vec2 q) { return std::max(std::abs(q.x), std::abs(q.y)); }

// A border runs along the rows if the sine of the angle between them is less: 12°.
inline constexpr double along_sine = 0.2079;

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

// Exact rows of one direction, anchored where the box about the area, turned into the rows' frame, has its lower left
// corner, so that whole stones start there.
std::vector<Particle> straight_rows(const geometry::RegionIndex& area, vec2 along, vec2 pitch, double band_mm);

// Rows along any field, as regular as the field allows, beginning half a pitch from borders that run along or across them.
std::vector<Particle> rows_along(const DirectionField& field, const geometry::RegionIndex& area, vec2 pitch, double band_mm,
                                 std::uint64_t seed);

}  // namespace shatterpave::paving
