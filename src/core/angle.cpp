#include "core/angle.h"

#include <cmath>

namespace shatterpave {

Angle Angle::of(vec2 v) { return radians(arctangent(v.y, v.x)); }

vec2 Angle::direction() const { return {cosine(radians_), sine(radians_)}; }

Angle Angle::wrapped() const {
  const double turns = std::ceil(radians_ / (2.0 * pi) - 0.5);
  return radians(radians_ - turns * 2.0 * pi);
}

vec2 rotated(vec2 v, Angle angle) {
  const vec2 turn = angle.direction();
  return {turn.x * v.x - turn.y * v.y, turn.y * v.x + turn.x * v.y};
}

}  // namespace shatterpave
