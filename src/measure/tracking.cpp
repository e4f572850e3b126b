#include "measure/tracking.h"

#include <algorithm>
#include <cmath>

namespace shatterpave::measure {

vec2 way_out(vec2 centre, double radius, vec2 from, vec2 to) {
  const vec2 along = to - from;
  const vec2 off = from - centre;
  const double a = glm::dot(along, along);
  const double b = glm::dot(along, off);
  const double c = glm::dot(off, off) - radius * radius;
  const double share = (std::sqrt(std::max(b * b - a * c, 0.0)) - b) / a;
  return from + std::clamp(share, 0.0, 1.0) * along;
}

std::vector<vec2> tracked(std::span<const vec2> line, double step_mm) {
  std::vector<vec2> points = {line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    vec2 from = line[i - 1];
    // A segment may be many steps long.
    while (glm::length(line[i] - points.back()) >= step_mm) {
      from = way_out(points.back(), step_mm, from, line[i]);
      points.push_back(from);
    }
  }
  return points;
}

std::vector<vec2> at_whole_pixels(std::vector<vec2> feature_points, vec2 origin) {
  for (vec2& point : feature_points) {
    const vec2 px = (point - origin) / glass::px_mm;
    point = origin + glass::px_mm * vec2{std::floor(px.x + 0.5), std::floor(px.y + 0.5)};
  }
  return feature_points;
}

std::vector<Angle> turns(std::span<const vec2> feature_points) {
  std::vector<Angle> result;
  if (feature_points.size() > 2) result.reserve(feature_points.size() - 2);
  for (std::size_t i = 2; i < feature_points.size(); ++i) {
    const vec2 before = feature_points[i - 1] - feature_points[i - 2];
    const vec2 after = feature_points[i] - feature_points[i - 1];
    result.push_back(Angle::radians(arctangent(cross(before, after), glm::dot(before, after))));
  }
  return result;
}

}  // namespace shatterpave::measure
