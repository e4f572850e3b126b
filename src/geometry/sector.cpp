#include "geometry/sector.h"

#include <algorithm>

#include "core/error.h"
#include "geometry/way_part.h"

namespace shatterpave::geometry {

SectorShape::SectorShape(Angle opening, double radius) : half_((opening * 0.5).direction()), radius_(radius) {
  ENSURE(opening > Angle() && opening <= Angle::radians(pi) && radius > 0.0);
}

Sector::Sector(vec2 apex, vec2 axis, const SectorShape& shape)
    : apex_(apex),
      right_(shape.half_.x * axis - shape.half_.y * left_of(axis)),
      left_(shape.half_.x * axis + shape.half_.y * left_of(axis)),
      radius_(shape.radius_) {
  // The corners of the fan, and where its arc goes farthest left, right, down or up.
  const auto ahead = [this](double x, double y) { return cross(right_, vec2{x, y}) > 0.0 && cross(vec2{x, y}, left_) > 0.0; };
  low_ = {ahead(-1.0, 0.0) ? -1.0 : std::min({0.0, right_.x, left_.x}),
          ahead(0.0, -1.0) ? -1.0 : std::min({0.0, right_.y, left_.y})};
  high_ = {ahead(1.0, 0.0) ? 1.0 : std::max({0.0, right_.x, left_.x}),
           ahead(0.0, 1.0) ? 1.0 : std::max({0.0, right_.y, left_.y})};
}

bool Sector::may_meet(vec2 low, vec2 high, double reach) const {
  const vec2 from = low - apex_;
  const vec2 to = high - apex_;
  const vec2 nearest = glm::clamp(vec2{0.0, 0.0}, from, to);
  if (glm::dot(nearest, nearest) > reach * reach) return false;
  // The corner that lies farthest to the left of the right border, and the one farthest to the right of the left border.
  const vec2 left_most{right_.y < 0.0 ? to.x : from.x, right_.x > 0.0 ? to.y : from.y};
  const vec2 right_most{left_.y > 0.0 ? to.x : from.x, left_.x < 0.0 ? to.y : from.y};
  return cross(right_, left_most) >= 0.0 && cross(right_most, left_) >= 0.0;
}

std::optional<vec2> Sector::nearest_point(vec2 a, vec2 b) const {
  const vec2 from = a - apex_;
  const vec2 to = b - apex_;
  double first = 0.0;
  double last = 1.0;
  keep_non_negative(cross(right_, from), cross(right_, to), first, last);
  keep_non_negative(cross(from, left_), cross(to, left_), first, last);
  if (first > last) return std::nullopt;
  const vec2 along = to - from;
  const double length2 = glm::dot(along, along);
  const double foot = length2 > 0.0 ? -glm::dot(from, along) / length2 : 0.0;
  const vec2 point = from + std::clamp(foot, first, last) * along;
  if (glm::dot(point, point) > radius_ * radius_) return std::nullopt;
  return apex_ + point;
}

}  // namespace shatterpave::geometry
