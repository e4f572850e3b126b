// [[pavement]] of a scene file.
#pragma once

#include "scene/scene.h"
#include "scene/schema/names.h"
#include "scene/schema/section.h"

namespace shatterpave::scene {

// Puts all pavements of a scene, from its root table, into `scene`, each with the places of its keys; the names of the tables
// go to `names`. A table with several areas makes a pavement of each, all with its name.
void read_pavements(const TomlTable& root, Plans& plans, Names& names, Scene& scene);

}  // namespace shatterpave::scene
