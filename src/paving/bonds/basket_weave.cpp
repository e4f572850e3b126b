// Basket weave: square blocks of stones side by side, along u and along v by turns. stone_mm = [a, b], a >= b: a is the length;
// round(a / b) stones, with their joints, make a block, so that b is adjusted to fit.
#include <algorithm>
#include <cmath>

#include "geometry/corners.h"
#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"

namespace shatterpave::paving {

namespace {

Pattern basket_weave_pattern(const Pavement& pavement) {
  const vec2 pitch = pitch_mm(pavement);
  const double a = pitch.x;
  const int count = std::max(1, static_cast<int>(std::lround(pitch.x / pitch.y)));
  const auto edge = [&](int k) { return a * k / count; };
  Pattern pattern{{2.0 * a, a}, 0.5, {}};
  for (int k = 0; k < count; ++k) {
    pattern.tiles.push_back({geometry::rectangle({{0.0, edge(k)}, {a, edge(k + 1)}}), along_u});
    pattern.tiles.push_back({geometry::rectangle({{a + edge(k), 0.0}, {a + edge(k + 1), a}}), along_v});
  }
  return pattern;
}

double basket_weave_area_mm2(const Pavement& pavement) {
  const vec2 pitch = pitch_mm(pavement);
  return pitch.x * pitch.x / std::max(1.0, std::round(pitch.x / pitch.y));
}

}  // namespace

extern constinit const BondType basket_weave_bond{
    .id = Bond::basket_weave,
    .name = "basket_weave",
    .sentence = "blocks of stones side by side, turned by turns",
    .stone_words = "a ≥ b: a is the length; round(a / b) stones and their joints make a square, so b is adjusted",
    .stock_words = largest_of_pattern,
    .is_for_scenes = true,
    .bending = Bending::straight,
    .drawing = Drawing::never,
    .shapes = not_wider_than_long,
    .takes_offset = false,
    .takes_span = false,
    .takes_module = false,
    .has_square_stones = true,
    .has_stones_of_a_size = true,
    .pattern_turn = Angle(),
    .mean_area_mm2 = basket_weave_area_mm2,
    .whole_face_mm2 = stone_face_mm2,
    .stock = pattern_stock,
    .pattern = basket_weave_pattern,
    .tiles = pattern_tiles,
};

}  // namespace shatterpave::paving
