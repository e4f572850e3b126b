// Herringbone: oblong stones at right angles, in steps. stone_mm = [a, b], a >= b, is the face of each stone.
//
// A stone lies, and another stands on its left end; the two go up the stairs by (b, b). The next stairs, one stone's length to
// the right and down, (a, −a), fit for any a >= b. Both steps are at 45° and at right angles to each other, so u of the pattern
// runs along the steps, and the stones lie along the rows and across them.
#include <cmath>

#include "geometry/corners.h"
#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"

namespace shatterpave::paving {

namespace {

Pattern herringbone_pattern(const Pavement& pavement) {
  const vec2 pitch = pitch_mm(pavement);
  const double a = pitch.x;
  const double b = pitch.y;
  const double half_root = std::sqrt(0.5);
  const auto turned = [&](vec2 p) { return half_root * vec2{p.x + p.y, p.y - p.x}; };
  Pattern pattern{{b / half_root, a / half_root}, 0.0, {}};
  pattern.tiles = {{geometry::rectangle({{0.0, 0.0}, {a, b}}), along_u},
                   {geometry::rectangle({{0.0, b}, {b, a + b}}), along_v}};
  for (Tile& tile : pattern.tiles) {
    for (vec2& p : tile.outline_mm) p = turned(p);
    tile.axis = turned(tile.axis);
  }
  return pattern;
}

}  // namespace

extern constinit const BondType herringbone_bond{
    .id = Bond::herringbone,
    .name = "herringbone",
    .sentence = "oblong stones at right angles, in steps",
    .stone_words = "the face of each stone, a ≥ b",
    .stock_words = stone_itself,
    .is_for_scenes = true,
    .bending = Bending::straight,
    .drawing = Drawing::never,
    .shapes = not_wider_than_long,
    .takes_offset = false,
    .takes_span = false,
    .takes_module = false,
    .has_square_stones = true,
    .has_stones_of_a_size = true,
    .pattern_turn = Angle::degrees(45.0),
    .mean_area_mm2 = pitch_area_mm2,
    .whole_face_mm2 = stone_face_mm2,
    .stock = stone_stock,
    .pattern = herringbone_pattern,
    .tiles = pattern_tiles,
};

}  // namespace shatterpave::paving
