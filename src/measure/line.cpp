#include "measure/line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shatterpave::measure {

namespace {

vec2 mean_of(std::span<const vec2> points) {
  vec2 sum{0.0, 0.0};
  for (const vec2& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

}  // namespace

Line fitted_line(std::span<const vec2> points) {
  Line line;
  line.count = points.size();
  line.slope_error = line.intercept_error = std::numeric_limits<double>::infinity();
  if (points.empty()) return line;
  const vec2 mean = mean_of(points);
  const auto by_x = [](const vec2& a, const vec2& b) { return a.x < b.x; };
  line.low_x = std::min_element(points.begin(), points.end(), by_x)->x;
  line.high_x = std::max_element(points.begin(), points.end(), by_x)->x;

  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const vec2& p : points) {
    const vec2 off = p - mean;
    xx += off.x * off.x;
    xy += off.x * off.y;
    yy += off.y * off.y;
  }
  const bool has_spread = line.low_x < line.high_x;
  line.slope = has_spread ? xy / xx : 0.0;
  line.intercept = mean.y - line.slope * mean.x;
  if (has_spread && yy > 0.0) line.correlation = xy / std::sqrt(xx * yy);
  if (points.size() < 3) return line;

  const double count = static_cast<double>(points.size());
  double squares = 0.0;
  for (const vec2& p : points) squares += (p.y - line.at(p.x)) * (p.y - line.at(p.x));
  line.residual = std::sqrt(squares / (count - 2.0));
  if (!has_spread) return line;
  line.slope_error = line.residual / std::sqrt(xx);
  line.intercept_error = line.residual * std::sqrt(1.0 / count + mean.x * mean.x / xx);
  return line;
}

}  // namespace shatterpave::measure
