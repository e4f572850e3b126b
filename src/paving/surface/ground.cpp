#include "paving/surface/ground.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace shatterpave::paving {

namespace {

// 6t⁵ − 15t⁴ + 10t³ and its derivative.
double ease(double t) { return t * t * t * (t * (6.0 * t - 15.0) + 10.0); }
double ease_slope(double t) { return 30.0 * t * t * (t - 1.0) * (t - 1.0); }

// Neighbouring pavements of a scene lie on the same ground, so its name is no part of the address.
double value(std::uint64_t seed, double column, double row) {
  const auto index = [](double cell) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(cell)); };
  return uniform(seed, {Stream::ground, Id("ground").child(index(column)).child(index(row))});
}

}  // namespace

GroundPoint settlement(const Ground& ground, std::uint64_t seed, vec2 place, std::optional<vec2> period_mm) {
  if (ground.settlement_mm == 0.0) return {};
  // A hollow and the ridge beside it are two cells.
  vec2 cell_mm = vec2{0.5, 0.5} * ground.settlement_length_mm;
  vec2 count{0.0, 0.0};
  if (period_mm) {
    count = 2.0 * glm::max(vec2{1.0, 1.0}, glm::floor(*period_mm / ground.settlement_length_mm + 0.5));
    cell_mm = *period_mm / count;
  }
  const vec2 at = place / cell_mm;
  const vec2 cell = glm::floor(at);
  const vec2 within = at - cell;
  const auto corner = [&](double x, double y) {
    vec2 at_cell = cell + vec2{x, y};
    if (period_mm) at_cell -= count * glm::floor(at_cell / count);
    return value(seed, at_cell.x, at_cell.y);
  };
  const double a = corner(0.0, 0.0);
  const double b = corner(1.0, 0.0) - a;
  const double c = corner(0.0, 1.0) - a;
  const double d = corner(1.0, 1.0) - a - b - c;
  const double u = ease(within.x);
  const double v = ease(within.y);
  const double scale = ground.settlement_mm;
  return {scale * (a + b * u + c * v + d * u * v - 1.0),
          scale / cell_mm * vec2{ease_slope(within.x) * (b + d * v), ease_slope(within.y) * (c + d * u)}};
}

vec2 fall(const Ground& ground) {
  return ground.fall_percent == 0.0 ? vec2{0.0, 0.0} : -0.01 * ground.fall_percent * ground.fall_direction.direction();
}

double ground_square_mm(const Pavement& pavement) {
  constexpr double squares_of_hollow = 12.0;
  constexpr double most_squares = 400.0;
  const geometry::Box box = geometry::bounding_box(pavement.area.outline);
  const vec2 size = box.high - box.low;
  return std::max(pavement.ground.settlement_length_mm / squares_of_hollow, std::max(size.x, size.y) / most_squares);
}

std::optional<double> water_level_mm(const Look& look, std::vector<double> faces_mm) {
  if (look.wetness <= 0.5 || faces_mm.empty()) return std::nullopt;
  constexpr double flooded_when_wettest = 1.0 / 3.0;
  std::ranges::sort(faces_mm);
  const double share = 2.0 * (look.wetness - 0.5) * flooded_when_wettest;
  return faces_mm[static_cast<std::size_t>(share * static_cast<double>(faces_mm.size() - 1))];
}

}  // namespace shatterpave::paving
