// Whether the key of an override is one that scenes have.
#pragma once

#include "scene/schema/key.h"
#include "scene/toml/apply_override.h"

namespace shatterpave::scene {

// The key to which that of the change leads in the scene; null where it leads to an element of a list. Throws InputError where
// it leads to none: with the name that was probably meant, as for a key of the file, or with what it goes on after.
const Key* require_known(const Override& change, const toml::table& scene);

}  // namespace shatterpave::scene
