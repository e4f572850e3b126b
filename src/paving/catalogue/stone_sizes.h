// Stones as the trade sells them, with the joints that they are laid with.
#pragma once

#include <array>
#include <string_view>

#include "core/vec.h"

namespace shatterpave::paving {

struct StonePreset {
  std::string_view name;
  vec2 stone_mm{0.0, 0.0};
  double joint_mm = 0.0;
};

// Setts: classes of EN 1342 as they are called and laid in Central Europe (mosaic 4 to 6 cm with joints of 4 to 6 mm, small 8
// to 10 cm with 6 to 10 mm, large 12 to 22 by 12 to 16 cm with 10 to 15 mm); here the middle of each. Bricks: work sizes usual
// for clay pavers of EN 1344 (200 × 100; clinker 240 × 118; Dutch Waal format 200 × 50), laid with joints of 3 to 5 mm. Flags:
// the module of a patio pack of natural stone (290 with joints of 10 mm, so that larger ones are 590 and 890).
inline constexpr std::array<StonePreset, 7> stone_presets{{
    {"mosaic_sett", {50.0, 50.0}, 5.0},
    {"small_sett", {90.0, 90.0}, 8.0},
    {"large_sett", {170.0, 140.0}, 12.0},
    {"brick", {200.0, 100.0}, 4.0},
    {"clinker", {240.0, 118.0}, 4.0},
    {"waal", {200.0, 50.0}, 4.0},
    {"flagstone", {290.0, 290.0}, 10.0},
}};

// Kerbs and steps are of blocks, which are set close.
inline constexpr double widest_block_joint_mm = 6.0;

}  // namespace shatterpave::paving
