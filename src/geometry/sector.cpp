#include "geometry/sector.h"

#include <algorithm>
#include <array>

#include "core/error.h"

namespace shatterpave::geometry {

namespace {

// Narrows [first, last] to where value_a + t (value_b − value_a) >= 0; an empty range has first > last.
void keep_non_negative(double value_a, double value_b, double& first, double& last) {
  if (value_a < 0.0 && value_b < 0.0) {
    first = 1.0;
    last = 0.0;
  } else if (value_a < 0.0) {
    first = std::max(first, value_a / (value_a - value_b));
  } else if (value_b < 0.0) {
    last = std::min(last, value_a / (value_a - value_b));
  }
}

}  // namespace

Sector::Sector(vec2 apex, vec2 axis, Angle opening, double radius)
    : apex_(apex), right_(rotated(axis, opening * -0.5)), left_(rotated(axis, opening * 0.5)), radius_(radius) {
  ENSURE(opening > Angle() && opening <= Angle::radians(pi) && radius > 0.0);
}

bool Sector::contains(vec2 point) const {
  const vec2 p = point - apex_;
  return cross(right_, p) >= 0.0 && cross(p, left_) >= 0.0 && glm::dot(p, p) <= radius_ * radius_;
}

bool Sector::may_meet(vec2 low, vec2 high) const {
  const vec2 nearest = glm::clamp(apex_, low, high) - apex_;
  if (glm::dot(nearest, nearest) > radius_ * radius_) return false;
  const std::array<vec2, 4> corners = {low - apex_, vec2{high.x, low.y} - apex_, high - apex_, vec2{low.x, high.y} - apex_};
  const bool right_of_it = std::ranges::all_of(corners, [this](vec2 p) { return cross(right_, p) < 0.0; });
  const bool left_of_it = std::ranges::all_of(corners, [this](vec2 p) { return cross(p, left_) < 0.0; });
  return !right_of_it && !left_of_it;
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
