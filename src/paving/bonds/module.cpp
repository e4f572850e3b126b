// A module: the stones of one repeat of a pattern that a user drew, and the two vectors by which it repeats. `stone_mm` has no
// effect: stones are as they are drawn, and it becomes the smallest of them (module_cells.h), as it is of an ashlar.
//
// The drawing's x runs along the rows. The first stone of the drawing has its lower left corner where the pattern begins.
#include <algorithm>
#include <cmath>

#include "geometry/corners.h"
#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"

namespace shatterpave::paving {

namespace {

// How far a lattice point lies along a vector, as a part of it.
double part_along(vec2 point, vec2 vector) { return glm::dot(point, vector) / glm::dot(vector, vector); }

Pattern module_pattern(const Pavement& pavement) {
  const Module& drawn = pavement.bonding.module_drawn;
  if (drawn.stones.empty()) {
    const vec2 pitch = pitch_mm(pavement);
    return {pitch, 0.0, {{geometry::rectangle({{0.0, 0.0}, pitch}), along_u}}};
  }
  const double length = glm::length(drawn.along_mm);
  const double moved = part_along(drawn.across_mm, drawn.along_mm);
  Pattern pattern{
      {length, cross(drawn.along_mm, drawn.across_mm) / length}, moved - std::floor(moved), {}, drawn.along_mm / length};
  pattern.tiles.reserve(drawn.stones.size());
  for (const Module::Stone& stone : drawn.stones) pattern.tiles.push_back({stone.cell_mm, stone.axis});
  return pattern;
}

double module_area_mm2(const Pavement& pavement) {
  const Module& drawn = pavement.bonding.module_drawn;
  if (drawn.stones.empty()) return pitch_area_mm2(pavement);
  return cross(drawn.along_mm, drawn.across_mm) / static_cast<double>(drawn.stones.size());
}

// As of an ashlar, the smallest stone: a piece that is small beside the others is no smaller than some whole stones.
double module_face_mm2(const Pavement& pavement) {
  const Module& drawn = pavement.bonding.module_drawn;
  return drawn.stones.empty() ? stone_face_mm2(pavement) : drawn.least_face_mm2;
}

}  // namespace

extern constinit const BondType module_bond{
    .id = Bond::drawn_module,
    .name = "module",
    .sentence = "stones that are drawn, one repeat of them in an SVG, and the two vectors by which it repeats",
    .stone_words = "no effect: stones are as they are drawn",
    .stock_words = largest_of_pattern,
    .is_for_scenes = true,
    .bending = Bending::straight,
    .drawing = Drawing::never,
    .shapes = any_shape,
    .takes_offset = false,
    .takes_span = false,
    .takes_module = true,
    .has_square_stones = false,
    .has_stones_of_a_size = false,
    .pattern_turn = Angle(),
    .mean_area_mm2 = module_area_mm2,
    .whole_face_mm2 = module_face_mm2,
    .stock = pattern_stock,
    .pattern = module_pattern,
    .tiles = pattern_tiles,
};

}  // namespace shatterpave::paving
