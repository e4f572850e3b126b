// [[pane]] of a scene file.
#pragma once

#include "scene/scene.h"
#include "scene/schema/names.h"
#include "scene/schema/section.h"

namespace shatterpave::scene {

// Puts all panes of a scene, from its root table, into `scene`, each with the places of its keys; their names go to `names`.
void read_panes(const TomlTable& root, Plans& plans, Names& names, Scene& scene);

}  // namespace shatterpave::scene
