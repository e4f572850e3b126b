// The experiments that Agui et al. 1992 print (§4.3), by name.
#pragma once

#include <span>
#include <string_view>

#include "glass/pane.h"

namespace shatterpave::glass {

// Growth::count_dispersion of the nineteen measured panes (Table 1, by 18 degrees of freedom), where eq. 5 has 1.
inline constexpr double table_1_dispersion = 29.6;

struct Preset {
  std::string_view name;   // such as "agui1992-fig15a"
  int radial_count = 0;    // M
  int circular_count = 0;  // R
  int large_count = 0;     // N
  Growth growth;           // speeds and law of Rand as printed, the rest by default
};

// All twelve, in the order of the figures.
std::span<const Preset> presets();

// The preset of that name, or null.
const Preset* preset(std::string_view name);

}  // namespace shatterpave::glass
