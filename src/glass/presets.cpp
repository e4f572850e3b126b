#include "glass/presets.h"

#include <algorithm>
#include <array>

namespace shatterpave::glass {

namespace {

Growth growth(Spread spread, double large_speed, double radial_speed) {
  Growth result;
  result.spread = spread;
  result.large_speed = large_speed;
  result.radial_speed = radial_speed;
  result.circular_speed = 10.0;  // V3 of all twelve
  return result;
}

// §4.3, the lists of parameters of Figs. 14, 15 and 16.
const std::array<Preset, 12>& all_presets() {
  static const std::array<Preset, 12> all = {{
      {"agui1992-fig14a", 113, 6, 11, growth(Spread::normal, 30.0, 5.0)},
      {"agui1992-fig14b", 104, 5, 10, growth(Spread::normal, 40.0, 5.0)},
      {"agui1992-fig14c", 113, 6, 11, growth(Spread::normal, 50.0, 5.0)},
      {"agui1992-fig14d", 95, 5, 10, growth(Spread::normal, 60.0, 5.0)},
      {"agui1992-fig15a", 114, 6, 11, growth(Spread::normal, 40.0, 10.0)},
      {"agui1992-fig15b", 98, 5, 10, growth(Spread::normal, 40.0, 10.0)},
      {"agui1992-fig15c", 105, 5, 10, growth(Spread::normal, 40.0, 10.0)},
      {"agui1992-fig15d", 92, 5, 9, growth(Spread::normal, 40.0, 10.0)},
      {"agui1992-fig16a", 104, 5, 10, growth(Spread::uniform, 40.0, 10.0)},
      {"agui1992-fig16b", 89, 4, 8, growth(Spread::uniform, 40.0, 10.0)},
      {"agui1992-fig16c", 108, 5, 9, growth(Spread::uniform, 40.0, 10.0)},
      {"agui1992-fig16d", 96, 5, 10, growth(Spread::uniform, 40.0, 10.0)},
  }};
  return all;
}

}  // namespace

void apply(const WindowPreset& preset, Pane& pane) {
  pane.thickness_mm = preset.thickness_mm;
  pane.pattern = Pattern::real;
  pane.crack_body = CrackBody::sheet;
  pane.crack_sheet.twist_mm = preset.twist_mm;
  pane.shards = ShardRules{};
  pane.shards->leaning = true;
}

void apply(const WindowPreset& preset, Impact& impact) {
  impact.ball_diameter_mm = preset.ball_diameter_mm;
  impact.speed_m_s = preset.speed_m_s;
}

std::span<const Preset> presets() { return all_presets(); }

const Preset* preset(std::string_view name) {
  const auto found = std::ranges::find(all_presets(), name, &Preset::name);
  return found == all_presets().end() ? nullptr : &*found;
}

}  // namespace shatterpave::glass
