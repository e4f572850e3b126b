// Inside the room: what each thing of a scene is made from, so that it need not be made anew for each frame.
#pragma once

#include <toml++/toml.h>

#include "scene/scene.h"

namespace shatterpave::scene {

// Fills `pane_sums` and `pavement_sums` of a scene that was read from the table.
void sum_things(const toml::table& table, Scene& scene);

}  // namespace shatterpave::scene
