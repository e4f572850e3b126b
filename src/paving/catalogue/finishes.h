// Finishes of stone as the trade names them, and what each means for the body of a stone.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "paving/pavement.h"

namespace shatterpave::paving {

// A finish sets all of these; a key given beside it wins.
struct FinishPreset {
  std::string_view name;
  StoneBody body;
  double height_mm = 0.0;  // of the faces above the filling of the joints
  double height_spread = 0.0;
  double tilt_deg = 0.0;
  Relief relief;
};

// Arrises: EN 1341 and EN 1342 call an arris of up to 2 mm sharp, and allow hewn setts to be uneven by 5 mm and textured ones
// by 3 mm. The rest is chosen by eye, after paving of that kind.
inline constexpr std::array<FinishPreset, 4> finish_presets{{
    {"flat_sawn", {Finish::flat_sawn, Arris::chamfered, 2.0, 0.0, 0.0, 0.0, 0.0}, 3.0, 0.10, 0.10, {0.05, 0.5}},
    {"bush_hammered", {Finish::bush_hammered, Arris::rounded, 3.0, 0.4, 0.3, 0.0, 0.6}, 5.0, 0.15, 0.3, {0.45, 0.25}},
    {"split", {Finish::split, Arris::rounded, 7.0, 2.0, 2.0, 0.0, 3.0}, 9.0, 0.20, 1.0, {1.1, 0.75}},
    {"river_worn", {Finish::river_worn, Arris::rounded, 22.0, 5.0, 1.5, 0.0, 0.0}, 14.0, 0.25, 1.5, {0.30, 0.80}},
}};

constexpr const FinishPreset& preset_of(Finish finish) {
  return *std::ranges::find(finish_presets, finish, [](const FinishPreset& preset) { return preset.body.finish; });
}

}  // namespace shatterpave::paving
