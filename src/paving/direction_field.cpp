#include "paving/direction_field.h"

#include <cmath>

namespace shatterpave::paving {

namespace {

vec2 unit(vec2 v, vec2 otherwise) {
  const double length = std::sqrt(glm::dot(v, v));
  return length > 0.0 ? v / length : otherwise;
}

constexpr vec2 along_x{1.0, 0.0};

}  // namespace

DirectionField::DirectionField(const Direction& direction, const geometry::RegionIndex& area)
    : direction_(direction), area_(&area) {}

vec2 DirectionField::axis(vec2 place) const {
  if (const auto* constant = std::get_if<ConstantDirection>(&direction_)) return constant->angle.direction();
  if (const auto* radial = std::get_if<RadialDirection>(&direction_)) return unit(left_of(place - radial->centre_mm), along_x);
  const auto& nearest = area_->segments()[area_->nearest(place).segment];
  return unit(nearest.to - nearest.from, along_x);
}

Angle DirectionField::angle(vec2 place) const {
  vec2 direction = axis(place);
  if (direction.x < 0.0 || (direction.x == 0.0 && direction.y < 0.0)) direction = -direction;
  return Angle::of(direction);
}

}  // namespace shatterpave::paving
