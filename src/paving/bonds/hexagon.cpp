// Honeycomb. stone_mm = [a, b]: a across flats, along the rows; the honeycomb is stretched by b / a across them.
//
// Two sides of each stone stand across the rows, and are pitch.x apart; a regular one has sides of pitch.x / √3.
#include <cmath>

#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"

namespace shatterpave::paving {

namespace {

Pattern hexagon_pattern(const Pavement& pavement) {
  const vec2 pitch = pitch_mm(pavement);
  const double half = 0.5 * pitch.x;
  const double side = pitch.y / std::sqrt(3.0);
  return {{pitch.x, 1.5 * side},
          0.5,
          {{{{half, -side}, {pitch.x, -0.5 * side}, {pitch.x, 0.5 * side}, {half, side}, {0.0, 0.5 * side}, {0.0, -0.5 * side}},
            along_u}}};
}

// A regular hexagon over the square on its width.
double of_a_square() { return 0.5 * std::sqrt(3.0); }

double hexagon_area_mm2(const Pavement& pavement) {
  const vec2 pitch = pitch_mm(pavement);
  return of_a_square() * pitch.x * pitch.y;
}

double hexagon_face_mm2(const Pavement& pavement) { return of_a_square() * stone_face_mm2(pavement); }

}  // namespace

extern constinit const BondType hexagon_bond{
    .id = Bond::hexagon,
    .name = "hexagon",
    .sentence = "honeycomb",
    .stone_words = "a across flats; stretched by b / a across the rows",
    .stock_words = largest_of_pattern,
    .is_for_scenes = true,
    .bending = Bending::straight,
    .drawing = Drawing::never,
    .shapes = any_shape,
    .takes_offset = false,
    .takes_span = false,
    .takes_module = false,
    .has_square_stones = false,
    .has_stones_of_a_size = true,
    .pattern_turn = Angle(),
    .mean_area_mm2 = hexagon_area_mm2,
    .whole_face_mm2 = hexagon_face_mm2,
    .stock = pattern_stock,
    .pattern = hexagon_pattern,
    .tiles = pattern_tiles,
};

}  // namespace shatterpave::paving
