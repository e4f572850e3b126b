// Sets a value of a parsed scene file.
#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "scene/override.h"

namespace shatterpave::scene {

// A step on the way to a value: a key or the name of an element, or its index.
using KeyStep = std::variant<std::string, std::size_t>;

// The steps of the key `a.b[0].c`. Throws InputError where it is none.
std::vector<KeyStep> key_steps(const Override& change);

// The element of an array that a step names: by its index, or by the `name` of a table. `path` is that of the array, for
// messages. Throws InputError where there is none.
toml::node& element_of(toml::array& array, const KeyStep& step, const Override& change, const std::string& path);

// The steps up to that one, as they were written.
std::string path_of(const std::vector<KeyStep>& steps, std::size_t count);

// A table `{value = …}` of the value, with the override as its source.
toml::table parsed_value(const Override& change);

// Sets the value in `scene`, before anything is validated. Tables that are missing on the way are made; elements of arrays
// are not. Throws InputError where the key leads nowhere.
void apply(const Override& change, toml::table& scene);

// Adds the value of `change`, an inline table, to the array of tables that is its key, which is made where it is missing.
// Returns the path of the new table: the key with its index. Throws InputError where the key leads nowhere, or to something
// else.
std::string append_table(const Override& change, toml::table& scene);

}  // namespace shatterpave::scene
