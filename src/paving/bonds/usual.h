// What many bonds have in common: values and functions for their rows of the table.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/region_index.h"
#include "paving/pavement.h"
#include "paving/tiles/pattern.h"
#include "paving/tiles/stock.h"
#include "paving/tiles/tiling.h"

namespace shatterpave::paving {

inline constexpr std::string_view each_stone = "the face of each stone";
inline constexpr std::string_view stone_itself = "`stone_mm`";
inline constexpr std::string_view largest_of_pattern = "the largest stone of the pattern";

// A stone and a joint along the rows, by as much across them.
double pitch_area_mm2(const Pavement& pavement);
double stone_face_mm2(const Pavement& pavement);

Stock stock_of(vec2 size_mm);
// `stone_mm`.
Stock stone_stock(const Pavement& pavement);
// The longest, the widest and the largest stone of the bond's pattern.
Stock pattern_stock(const Pavement& pavement);

// Where the bond's pattern lies: with a whole stone's corner in `Bonding::start_mm`, or else in the lower left corner of the
// box about the area that is turned with the pattern.
Placement placed(const Pavement& pavement, const Pattern& pattern, const geometry::RegionIndex& area);

// The bond's pattern, repeated over the area from there.
std::vector<Tile> pattern_tiles(const Pavement& pavement, const geometry::RegionIndex& area, std::uint64_t seed);

inline constexpr vec2 along_u{1.0, 0.0};
inline constexpr vec2 along_v{0.0, 1.0};

// The width of an arc or a fan, mm: the given one, or twelve stones.
double span_mm(const Pavement& pavement);

}  // namespace shatterpave::paving
