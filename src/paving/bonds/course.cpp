// One row along the outline of a ring, mitred at its corners: kerbs and steps round an area, which no scene asks for by this
// name. stone_mm: along the outline and across it; the ring is as wide as a stone and a joint.
#include "paving/bonds/border.h"
#include "paving/bonds/table.h"
#include "paving/bonds/usual.h"

namespace shatterpave::paving {

namespace {

std::vector<Tile> ring_course_tiles(const Pavement& pavement, const geometry::RegionIndex& /*area*/, std::uint64_t /*seed*/) {
  Pavement filled = pavement;
  filled.area.holes.clear();
  filled.border = {BorderCourse::stretcher, pavement.stone_mm};
  return border_tiles(filled, {pavement.area});
}

}  // namespace

extern constinit const BondType course_bond{
    .id = Bond::course,
    .name = "course",
    .sentence = "one row along the outline of a ring, mitred at its corners",
    .stone_words = "along the outline and across it",
    .stock_words = stone_itself,
    .is_for_scenes = false,
    .bending = Bending::straight,
    .drawing = Drawing::never,
    .shapes = any_shape,
    .takes_offset = false,
    .takes_span = false,
    .takes_module = false,
    .has_square_stones = false,
    .has_stones_of_a_size = false,
    .pattern_turn = Angle(),
    .mean_area_mm2 = pitch_area_mm2,
    .whole_face_mm2 = stone_face_mm2,
    .stock = stone_stock,
    .pattern = nullptr,
    .tiles = ring_course_tiles,
};

}  // namespace shatterpave::paving
