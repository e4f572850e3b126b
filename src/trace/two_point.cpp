#include "trace/two_point.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"

namespace shatterpave::trace {

namespace {

// How far the figure goes from `p` in that direction; nothing where it goes on beyond the reach.
std::optional<double> way_out(const Mask& figures, vec2 p, vec2 direction, double reach_px) {
  constexpr double step = 0.25;
  for (double gone = 0.0; gone <= reach_px; gone += step) {
    const vec2 at = p + gone * direction;
    const int x = static_cast<int>(std::floor(at.x));
    const int y = static_cast<int>(std::floor(at.y));
    if (!figures.holds(x, y) || figures.at(x, y) == 0) return gone;
  }
  return std::nullopt;
}

// Between L and R, on the line across `direction` through `p`.
vec2 middle_between_sides(const Mask& figures, vec2 p, vec2 direction, double reach_px) {
  const vec2 left = left_of(direction);
  const auto to_left = way_out(figures, p, left, reach_px);
  const auto to_right = way_out(figures, p, -left, reach_px);
  if (!to_left || !to_right) return p;
  return p + 0.5 * (*to_left - *to_right) * left;
}

}  // namespace

std::vector<vec2> feature_points(const Mask& figures, const std::vector<vec2>& middle_line, double step_px, double reach_px) {
  ENSURE(middle_line.size() >= 2);
  std::vector<vec2> points = {middle_line.front()};
  vec2 from = middle_line.front();
  for (std::size_t i = 1; i + 1 < middle_line.size(); ++i) {
    const double gone = glm::length(middle_line[i] - from);
    if (gone < step_px) continue;
    from = middle_line[i];
    // The direction along the line here: over a step to either side.
    std::size_t before = i;
    std::size_t after = i;
    while (before > 0 && glm::length(middle_line[before] - from) < 5.0) --before;
    while (after + 1 < middle_line.size() && glm::length(middle_line[after] - from) < 5.0) ++after;
    const vec2 along = middle_line[after] - middle_line[before];
    const double length = glm::length(along);
    points.push_back(length > 0.0 ? middle_between_sides(figures, from, along / length, reach_px) : from);
  }
  // A last step that is nearly none would turn anywhere.
  if (points.size() > 1 && glm::length(points.back() - middle_line.back()) < 0.5 * step_px) points.pop_back();
  points.push_back(middle_line.back());
  return points;
}

}  // namespace shatterpave::trace
