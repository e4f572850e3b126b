// Running bond: rows, each shifted against the one before. Rows bend with the direction.
#include "paving/bonds/row_tiles.h"
#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"

namespace shatterpave::paving {

namespace {

Pattern running_pattern(const Pavement& pavement) { return rows_pattern(pitch_mm(pavement), pavement.bonding.offset); }

std::vector<Tile> running_tiles(const Pavement& pavement, const geometry::RegionIndex& area, std::uint64_t /*seed*/) {
  return row_tiles(pavement, pavement.bonding.offset, area);
}

}  // namespace

extern constinit const BondType running_bond{
    .id = Bond::running,
    .name = "running",
    .sentence = "rows, each moved on against the last by `bond_offset`",
    .stone_words = each_stone,
    .stock_words = stone_itself,
    .is_for_scenes = true,
    .bending = Bending::rows,
    .drawing = Drawing::never,
    .shapes = any_shape,
    .takes_offset = true,
    .takes_span = false,
    .takes_module = false,
    .has_square_stones = true,
    .has_stones_of_a_size = true,
    .pattern_turn = Angle(),
    .mean_area_mm2 = pitch_area_mm2,
    .whole_face_mm2 = stone_face_mm2,
    .stock = stone_stock,
    .pattern = running_pattern,
    .tiles = running_tiles,
};

}  // namespace shatterpave::paving
