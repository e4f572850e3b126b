// Sets a value of a parsed scene file.
#pragma once

#include <toml++/toml.h>

#include <string>

#include "scene/override.h"

namespace shatterpave::scene {

// Sets the value in `scene`, before anything is validated. Tables that are missing on the way are made; elements of arrays
// are not. Throws InputError where the key leads nowhere.
void apply(const Override& change, toml::table& scene);

// Adds the value of `change`, an inline table, to the array of tables that is its key, which is made where it is missing.
// Returns the path of the new table: the key with its index. Throws InputError where the key leads nowhere, or to something
// else.
std::string append_table(const Override& change, toml::table& scene);

}  // namespace shatterpave::scene
