// [[pane]] of a scene file.
#pragma once

#include <vector>

#include "glass/pane.h"
#include "scene/section.h"

namespace shatterpave::scene {

// All panes of a scene, from its root table; their names go to `names`.
std::vector<glass::Pane> panes_of(const TomlTable& root, Plans& plans, Names& names);

}  // namespace shatterpave::scene
