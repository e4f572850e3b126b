// Sets a value of a parsed scene file.
#pragma once

#include <toml++/toml.h>

#include "scene/override.h"

namespace shatterpave::scene {

// Sets the value in `scene`, before anything is validated. Tables that are missing on the way are made; elements of arrays
// are not. Throws InputError where the key leads nowhere.
void apply(const Override& change, toml::table& scene);

}  // namespace shatterpave::scene
