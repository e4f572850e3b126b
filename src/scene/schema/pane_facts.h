// What decides whether the keys of a pane have an effect.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <variant>

#include "glass/pane.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

struct PaneFacts {
  static constexpr std::string_view path = "pane[]";
  const TomlTable& table;
  const glass::Pane& pane;

  bool has(std::string_view key) const { return table.place_of_given(key).has_value(); }
  bool is_tempered() const { return std::holds_alternative<glass::Tempered>(pane.glass); }
  bool is_laminated() const { return std::holds_alternative<glass::Laminated>(pane.glass); }
  bool is_real() const { return pane.pattern == glass::Pattern::real; }
  bool all_impacts(bool (*is_so)(const glass::Impact&)) const { return std::ranges::all_of(pane.impacts, is_so); }
};

struct ImpactFacts {
  static constexpr std::string_view path = "pane[].impact[]";
  const TomlTable& table;  // of the impact
  const PaneFacts& pane;
  const glass::Impact& impact;  // with what a preset sets

  bool has_crater() const { return pane.is_real() || pane.is_laminated(); }
};

inline constexpr std::string_view beside_tempered = "beside glass = \"tempered\"";
inline constexpr std::string_view beside_real = "beside pattern = \"real\"";
inline constexpr std::string_view beside_shards = "beside [pane.shards]";
inline constexpr std::string_view beside_counts = "beside radial_count, mean_radial_count or preset";

inline bool on_tempered(const PaneFacts& f) { return f.is_tempered(); }
inline bool on_real(const PaneFacts& f) { return f.is_real(); }

}  // namespace shatterpave::scene
