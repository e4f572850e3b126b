#include "geometry/convex_region.h"

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "geometry/way_part.h"

namespace shatterpave::geometry {

ConvexShape ConvexShape::sector(Angle opening, double radius) {
  ENSURE(opening > Angle() && opening <= Angle::radians(pi) && radius > 0.0);
  ConvexShape shape;
  const vec2 left = (opening * 0.5).direction();
  shape.left_ = left;
  shape.low_ = {0.0, -radius * left.y};
  shape.high_ = {radius, radius * left.y};
  shape.radius_ = radius;
  return shape;
}

ConvexShape ConvexShape::rectangle(double length, double width) {
  ENSURE(length > 0.0 && width > 0.0);
  ConvexShape shape;
  shape.low_ = {0.0, -0.5 * width};
  shape.high_ = {length, 0.5 * width};
  shape.radius_ = std::numeric_limits<double>::infinity();
  return shape;
}

ConvexShape ConvexShape::circle(double radius) {
  ENSURE(radius > 0.0);
  ConvexShape shape;
  shape.low_ = {-radius, -radius};
  shape.high_ = {radius, radius};
  shape.radius_ = radius;
  return shape;
}

ConvexRegion::ConvexRegion(vec2 origin, vec2 axis, const ConvexShape& shape)
    : origin_(origin), axis_(axis), shape_(shape), box_{origin, origin} {
  const auto corner = [&](double x, double y) { return origin + x * axis + y * left_of(axis); };
  box_.low = box_.high = corner(shape.low_.x, shape.low_.y);
  for (const vec2& p :
       {corner(shape.high_.x, shape.low_.y), corner(shape.high_.x, shape.high_.y), corner(shape.low_.x, shape.high_.y)}) {
    box_.low = glm::min(box_.low, p);
    box_.high = glm::max(box_.high, p);
  }
}

bool ConvexRegion::contains(vec2 point) const {
  const vec2 p = local(point);
  if (glm::any(glm::lessThan(p, shape_.low_)) || glm::any(glm::greaterThan(p, shape_.high_))) return false;
  if (shape_.left_) {
    const vec2 left = *shape_.left_;
    if (left.y * p.x - left.x * p.y < 0.0 || left.y * p.x + left.x * p.y < 0.0) return false;
  }
  return glm::dot(p, p) <= shape_.radius_ * shape_.radius_;
}

std::optional<vec2> ConvexRegion::nearest_point(vec2 a, vec2 b) const {
  const vec2 from = local(a);
  const vec2 to = local(b);
  double first = 0.0;
  double last = 1.0;
  keep_non_negative(from.x - shape_.low_.x, to.x - shape_.low_.x, first, last);
  keep_non_negative(shape_.high_.x - from.x, shape_.high_.x - to.x, first, last);
  keep_non_negative(from.y - shape_.low_.y, to.y - shape_.low_.y, first, last);
  keep_non_negative(shape_.high_.y - from.y, shape_.high_.y - to.y, first, last);
  if (shape_.left_) {
    const vec2 left = *shape_.left_;
    keep_non_negative(left.y * from.x - left.x * from.y, left.y * to.x - left.x * to.y, first, last);
    keep_non_negative(left.y * from.x + left.x * from.y, left.y * to.x + left.x * to.y, first, last);
  }
  if (first > last) return std::nullopt;
  const vec2 along = to - from;
  const double length2 = glm::dot(along, along);
  const double foot = length2 > 0.0 ? -glm::dot(from, along) / length2 : 0.0;
  const double share = std::clamp(foot, first, last);
  const vec2 point = from + share * along;
  if (glm::dot(point, point) > shape_.radius_ * shape_.radius_) return std::nullopt;
  return a + share * (b - a);
}

}  // namespace shatterpave::geometry
