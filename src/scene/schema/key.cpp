#include "scene/schema/key.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace shatterpave::scene {

namespace {

struct Unit {
  std::string_view ending;
  std::string_view unit;
};
// Of endings that end alike, longer ones come first.
constexpr auto units = std::to_array<Unit>({{"_mm2", "mm²"},
                                            {"_px2", "px²"},
                                            {"_m_s", "m/s"},
                                            {"_per_m", "1/m"},
                                            {"_mpa", "MPa"},
                                            {"_percent", "%"},
                                            {"_deg", "°"},
                                            {"_mm", "mm"},
                                            {"_px", "px"}});

}  // namespace

std::string_view unit_of(std::string_view name) {
  const auto found = std::ranges::find_if(units, [&](const Unit& unit) { return name.ends_with(unit.ending); });
  return found == units.end() ? std::string_view() : found->unit;
}

std::string number_text(double value) {
  std::string text = fmt::format("{:.6g}", value);
  if (std::abs(value) >= 1e4 && std::abs(value) < 1e18 && value == std::round(value)) text = fmt::format("{:.0f}", value);
  const bool negative = text.starts_with('-');
  if (negative) text.erase(0, 1);
  const std::size_t digits = std::min(text.find('.'), text.size());
  if (digits > 4 && text.find('e') == std::string::npos) {
    for (std::size_t at = digits; at > 3;) {
      at -= 3;
      if (at > 0) text.insert(at, 1, ',');
    }
  }
  return negative ? fmt::format("−{}", text) : text;
}

}  // namespace shatterpave::scene
