// How stones are laid by hand, by names of what one sees.
#pragma once

#include <array>
#include <string_view>

#include "paving/pavement.h"

namespace shatterpave::paving {

struct HandPreset {
  std::string_view name;
  HandLaying hand;
  double missing = 0.0;  // part of the stones
};

// The worn alley is what photographs of old paving measure: joints whose logarithm has a standard deviation of 0.6, sides of 12
// to 22 %, corners rounded by 5 to 15 %. The others are parts of the way there, by eye.
inline constexpr std::array<HandPreset, 3> hand_presets{{
    {"new-setts", {0.3, 0.03, 0.05, 0.0, {}}, 0.0},
    {"old-street", {0.65, 0.08, 0.2, 0.01, {}}, 0.0},
    {"worn-alley", {1.0, 0.1, 0.3, 0.02, {}}, 0.004},
}};

}  // namespace shatterpave::paving
