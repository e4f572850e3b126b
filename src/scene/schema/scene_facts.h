// What decides whether the keys of the whole scene have an effect.
#pragma once

#include <string_view>

#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

struct SceneFacts {
  static constexpr std::string_view path = "";
  const TomlTable& table;

  bool has_pane() const { return table.has("pane"); }
  // Whether a plan of that kind, in SVG or in GeoJSON, is taken anywhere in the scene.
  bool takes_plan(bool svg) const;
};

}  // namespace shatterpave::scene
