// Bonds of straight stones: rows, herringbone, basket weave, and the honeycomb.
#include <algorithm>
#include <cmath>

#include "paving/bonds/patterns.h"

namespace shatterpave::paving {

namespace {

geometry::Polygon rectangle(vec2 low, vec2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

constexpr vec2 along_u{1.0, 0.0};
constexpr vec2 along_v{0.0, 1.0};

}  // namespace

Pattern rows_pattern(vec2 pitch, double offset) { return {pitch, offset, {{rectangle({0.0, 0.0}, pitch), along_u}}}; }

// A stone lies, and another stands on its left end; the two go up the stairs by (b, b). The next stairs, one stone's length to
// the right and down, (a, −a), fit for any a >= b. Both steps are at 45° and at right angles to each other.
Pattern herringbone_pattern(vec2 pitch) {
  const double a = pitch.x;
  const double b = pitch.y;
  const double half_root = std::sqrt(0.5);
  const auto turned = [&](vec2 p) { return half_root * vec2{p.x + p.y, p.y - p.x}; };
  Pattern pattern{{b / half_root, a / half_root}, 0.0, {}};
  pattern.tiles = {{rectangle({0.0, 0.0}, {a, b}), along_u}, {rectangle({0.0, b}, {b, a + b}), along_v}};
  for (Tile& tile : pattern.tiles) {
    for (vec2& p : tile.outline_mm) p = turned(p);
    tile.axis = turned(tile.axis);
  }
  return pattern;
}

Pattern basket_weave_pattern(vec2 pitch) {
  const double a = pitch.x;
  const int count = std::max(1, static_cast<int>(std::lround(pitch.x / pitch.y)));
  const auto edge = [&](int k) { return a * k / count; };
  Pattern pattern{{2.0 * a, a}, 0.5, {}};
  for (int k = 0; k < count; ++k) {
    pattern.tiles.push_back({rectangle({0.0, edge(k)}, {a, edge(k + 1)}), along_u});
    pattern.tiles.push_back({rectangle({a + edge(k), 0.0}, {a + edge(k + 1), a}), along_v});
  }
  return pattern;
}

// Two sides of each stone stand across the rows, and are pitch.x apart; a regular one has sides of pitch.x / √3.
Pattern hexagon_pattern(vec2 pitch) {
  const double half = 0.5 * pitch.x;
  const double side = pitch.y / std::sqrt(3.0);
  return {{pitch.x, 1.5 * side},
          0.5,
          {{{{half, -side}, {pitch.x, -0.5 * side}, {pitch.x, 0.5 * side}, {half, side}, {0.0, 0.5 * side}, {0.0, -0.5 * side}},
            along_u}}};
}

}  // namespace shatterpave::paving
