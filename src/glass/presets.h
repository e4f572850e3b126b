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

// What is broken in everyday life, by name, with all that makes it so: no experiment.
struct WindowPreset {
  std::string_view name;
  vec2 size_mm{0.0, 0.0};  // where a scene does not say
  double thickness_mm = 0.0;
  double mean_radial_count = 0.0;
  int large_count = 0;
  double ball_diameter_mm = 0.0;
  double speed_m_s = 0.0;
  double twist_mm = 0.0;
};

// A stone that goes through a window pane: pattern "real", cracks as gaps, pieces that fall, whose walls lean, and a hole of
// arcs. By eye, beside photographs of such windows: 23 radials at the crushed zone, 12 to 14 outside, and a hole of about a
// half of the width of the pane.
inline constexpr WindowPreset stone_through_window{"stone-through-window", {600.0, 900.0}, 4.0, 30.0, 12, 40.0, 8.0, 40.0};

// Sets all of a pane that the preset says, but for its outline and its impacts; and of an impact of it. What a scene gives is
// read after that.
void apply(const WindowPreset& preset, Pane& pane);
void apply(const WindowPreset& preset, Impact& impact);

// All twelve, in the order of the figures.
std::span<const Preset> presets();

// The preset of that name, or null.
const Preset* preset(std::string_view name);

}  // namespace shatterpave::glass
