// Stack bond: rows with their perpends in line. Rows bend with the direction.
#include "paving/bonds/row_tiles.h"
#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"

namespace shatterpave::paving {

namespace {

Pattern stack_pattern(const Pavement& pavement) { return rows_pattern(pitch_mm(pavement), 0.0); }

std::vector<Tile> stack_tiles(const Pavement& pavement, const geometry::RegionIndex& area, std::uint64_t /*seed*/) {
  return row_tiles(pavement, 0.0, area);
}

}  // namespace

extern constinit const BondType stack_bond{
    .id = Bond::stack,
    .name = "stack",
    .sentence = "rows with perpends in line",
    .stone_words = each_stone,
    .stock_words = stone_itself,
    .is_for_scenes = true,
    .bending = Bending::rows,
    .drawing = Drawing::never,
    .shapes = any_shape,
    .takes_offset = false,
    .takes_span = false,
    .takes_module = false,
    .has_square_stones = true,
    .has_stones_of_a_size = true,
    .pattern_turn = Angle(),
    .mean_area_mm2 = pitch_area_mm2,
    .whole_face_mm2 = stone_face_mm2,
    .stock = stone_stock,
    .pattern = stack_pattern,
    .tiles = stack_tiles,
};

}  // namespace shatterpave::paving
