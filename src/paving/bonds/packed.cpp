// Square packing along the direction field (§3 of Miyata and Itoh). It is laid by paving/packing; in one direction it is plain
// rows with their perpends in line, so that it repeats.
#include "paving/bonds/row_tiles.h"
#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"

namespace shatterpave::paving {

namespace {

// By trial: of the whole stones of all plans of benchmarks/packing_quality none is larger by more.
constexpr double bent_stock = 1.5;

Stock packed_stock(const Pavement& pavement) {
  const bool is_straight = std::holds_alternative<ConstantDirection>(pavement.direction) && !has_sizes(pavement);
  return stock_of(is_straight ? pavement.stone_mm : bent_stock * size_range(pavement).largest * pavement.stone_mm);
}

Pattern packed_pattern(const Pavement& pavement) { return rows_pattern(pitch_mm(pavement), 0.0); }

}  // namespace

extern constinit const BondType packed_bond{
    .id = Bond::packed,
    .name = "packed",
    .sentence = "square packing along the direction, wherever it bends",
    .stone_words = each_stone,
    .stock_words =
        "`stone_mm` in one direction; where rows bend, or sizes follow a field, one and a half times that (of the largest "
        "size) each way, since no two stones are alike",
    .is_for_scenes = true,
    .bending = Bending::packed,
    .drawing = Drawing::where_bent,
    .shapes = any_shape,
    .takes_offset = false,
    .takes_span = false,
    .takes_module = false,
    .has_square_stones = true,
    .has_stones_of_a_size = true,
    .pattern_turn = Angle(),
    .mean_area_mm2 = pitch_area_mm2,
    .whole_face_mm2 = stone_face_mm2,
    .stock = packed_stock,
    .pattern = packed_pattern,
    .tiles = nullptr,
};

}  // namespace shatterpave::paving
