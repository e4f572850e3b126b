// Stones of a pattern lie on a torus: positions that differ by whole multiples of the two vectors are the same. So all that
// compares stones asks for the repeats of one that may meet another, by their extents in parts of the two vectors.
#pragma once

#include <cmath>
#include <utility>

#include "geometry/lattice.h"
#include "geometry/polygon.h"

namespace shatterpave::paving {

// The points at which the pattern repeats.
class Repeats {
 public:
  Repeats(vec2 first, vec2 second) : along_(first), across_(second) {
    // Lagrange's reduction, after which both are as short as they can be.
    constexpr int most_steps = 100;  // each at least halves the longer one
    for (int step = 0; step < most_steps; ++step) {
      if (glm::dot(across_, across_) < glm::dot(along_, along_)) std::swap(along_, across_);
      const double times = glm::dot(along_, across_) / glm::dot(along_, along_);
      constexpr double half = 0.5 + 1e-9;
      if (!(std::abs(times) > half)) break;
      across_ -= std::round(times) * along_;
    }
    if (cross(along_, across_) < 0.0) across_ = -across_;
    area_ = cross(along_, across_);
  }

  vec2 along() const { return along_; }
  vec2 across() const { return across_; }
  double area() const { return area_; }
  vec2 at(vec2 parts) const { return parts.x * along_ + parts.y * across_; }
  // A point in parts of the two vectors.
  vec2 parts_of(vec2 p) const { return {cross(p, across_) / area_, cross(along_, p) / area_}; }
  // How far a disc of that radius reaches, in parts of the two vectors.
  vec2 extent_of(double radius_mm) const { return radius_mm / area_ * vec2{glm::length(across_), glm::length(along_)}; }
  // The least of all vectors from the point to one at which the pattern repeats: exact where it is shorter than a quarter of
  // `along`.
  vec2 nearest(vec2 p) const {
    const vec2 parts = parts_of(p);
    return at({std::round(parts.x), std::round(parts.y)});
  }

 private:
  vec2 along_;
  vec2 across_;
  double area_ = 0.0;
};

// In parts of the vectors.
inline geometry::Box extent_in(const Repeats& repeats, const geometry::Polygon& polygon) {
  geometry::Box box{repeats.parts_of(polygon.front()), repeats.parts_of(polygon.front())};
  for (const vec2& p : polygon) box = {glm::min(box.low, repeats.parts_of(p)), glm::max(box.high, repeats.parts_of(p))};
  return box;
}

// Calls act(times) for each way by which `other` repeats so that it may meet `one`, both in parts of the vectors.
template <typename Act>
void for_repeats(const geometry::Box& one, const geometry::Box& other, const Act& act) {
  constexpr double rounding = 1e-9;
  const vec2 from = glm::ceil(one.low - other.high - rounding);
  const vec2 to = glm::floor(one.high - other.low + rounding);
  for (double j = from.y; j <= to.y; ++j) {
    for (double i = from.x; i <= to.x; ++i) act(vec2{i, j});
  }
}

inline geometry::Polygon moved(geometry::Polygon polygon, vec2 by) {
  for (vec2& p : polygon) p = geometry::on_lattice(p + by);
  return polygon;
}

}  // namespace shatterpave::paving
