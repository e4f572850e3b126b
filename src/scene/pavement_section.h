// [[pavement]] of a scene file.
#pragma once

#include <vector>

#include "paving/pavement.h"
#include "scene/toml_table.h"

namespace shatterpave::scene {

// All pavements of a scene, from its root table.
std::vector<paving::Pavement> pavements_of(const TomlTable& root);

}  // namespace shatterpave::scene
