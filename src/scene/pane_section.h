// [[pane]] of a scene file.
#pragma once

#include <vector>

#include "glass/pane.h"
#include "scene/toml_table.h"

namespace shatterpave::scene {

// All panes of a scene, from its root table.
std::vector<glass::Pane> panes_of(const TomlTable& root);

}  // namespace shatterpave::scene
