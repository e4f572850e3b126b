// [[pavement]] of a scene file.
#pragma once

#include <vector>

#include "paving/pavement.h"
#include "scene/section.h"

namespace shatterpave::scene {

// All pavements of a scene, from its root table; their names go to `names`. A table with several areas makes a pavement of
// each: NAME, NAME_2, NAME_3 …
std::vector<paving::Pavement> pavements_of(const TomlTable& root, Plans& plans, Names& names);

}  // namespace shatterpave::scene
