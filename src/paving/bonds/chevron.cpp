// Chevron (French: point de Hongrie): planks whose ends are cut at 45° lie side by side in rows; the next row leans the other
// way, so that planks meet in a straight line along the rows, and their joints in one point of it. With `bond_turn_deg` = 90
// those lines run across the rows' direction.
//
// stone_mm = [a, b] is measured as floor makers do: a along the plank between its two parallel ends, which is the length of
// each long side; b across it. From point to point a plank reaches a + b along its own axis: so long is the piece that it is
// cut from.
//
// Half a joint all round is b + joint across the plank, and the end of one is half a joint off the line at right angles to it.
// So a row is a / √2 + joint deep, and a plank takes √2 (b + joint) of it.
#include <cmath>

#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"

namespace shatterpave::paving {

namespace {

// Of a row along u: what a plank and its joint take of it, and its depth.
vec2 chevron_step(const Pavement& pavement) {
  const double root = std::sqrt(2.0);
  return {root * (pavement.stone_mm.y + pavement.joint_mm), pavement.stone_mm.x / root + pavement.joint_mm};
}

Pattern chevron_pattern(const Pavement& pavement) {
  const vec2 step = chevron_step(pavement);
  const double width = step.x;
  const double depth = step.y;
  const double half_root = std::sqrt(0.5);
  return {{width, 2.0 * depth},
          0.0,
          {{{{0.0, 0.0}, {width, 0.0}, {width + depth, depth}, {depth, depth}}, {half_root, half_root}},
           {{{depth, depth}, {depth + width, depth}, {width, 2.0 * depth}, {0.0, 2.0 * depth}}, {half_root, -half_root}}}};
}

double chevron_area_mm2(const Pavement& pavement) {
  const vec2 step = chevron_step(pavement);
  return step.x * step.y;
}

// From point to point, and across; of that a parallelogram.
Stock chevron_stock(const Pavement& pavement) {
  const vec2 stone = pavement.stone_mm;
  return {{stone.x + stone.y, stone.y}, stone.x * stone.y, {}, {1.0, 0.0}};
}

}  // namespace

extern constinit const BondType chevron_bond{
    .id = Bond::chevron,
    .name = "chevron",
    .sentence =
        "planks with ends cut at 45°, leaning to one side and to the other row by row, so that they meet in straight lines "
        "along the rows",
    .stone_words = "a: each long side of a plank, which is the length between its slanted ends; b: across it; a ≥ b",
    .stock_words = "a + b long, from point to point, and b wide, with an area of a · b",
    .is_for_scenes = true,
    .bending = Bending::straight,
    .drawing = Drawing::never,
    .shapes = not_wider_than_long,
    .takes_offset = false,
    .takes_span = false,
    .takes_module = false,
    .has_square_stones = false,
    .has_stones_of_a_size = true,
    .pattern_turn = Angle(),
    .mean_area_mm2 = chevron_area_mm2,
    .whole_face_mm2 = stone_face_mm2,
    .stock = chevron_stock,
    .pattern = chevron_pattern,
    .tiles = pattern_tiles,
};

}  // namespace shatterpave::paving
