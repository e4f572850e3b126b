// Sets a value of a parsed scene file.
#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/override.h"

namespace shatterpave::scene {

// A step on the way to a value: a key or the name of an element, or its index.
using KeyStep = std::variant<std::string, std::size_t>;

// The steps of the key `a.b[0].c`, or `a."b"[0].c` with quotes of either kind, as TOML has them; nothing where it is none.
std::optional<std::vector<KeyStep>> steps_of(std::string_view key);
// The same of a change. Throws InputError where its key is none.
std::vector<KeyStep> key_steps(const Override& change);

// The index of the element of an array that a step names: by that, or by the `name` of a table. `path` is that of the array,
// for messages. Throws InputError where there is none; `meant`, where it is not empty, is suggested if no name is near.
std::size_t element_index(const toml::array& array, const KeyStep& step, const Override& change, const std::string& path,
                          const std::string& meant = {});

// Throws InputError: the key goes on after `path`, which leads to `what`.
[[noreturn]] void refuse_way(const Override& change, const std::string& path, std::string_view what);

// The steps up to that one, as they were written.
std::string path_of(const std::vector<KeyStep>& steps, std::size_t count);

// A table `{value = …}` of the value, with the override as its source.
toml::table parsed_value(const Override& change);

// Sets the value in `scene`, whatever keys a scene has (scene/schema/known_path.h). Tables that are missing on the way are
// made; elements of arrays are not. Throws InputError where the key leads nowhere.
void apply(const Override& change, toml::table& scene);

// Adds the value of `change`, an inline table, to the array of tables that is its key, which is made where it is missing.
// Returns the path of the new table: the key with its index. Throws InputError where the key leads nowhere, or to something
// else.
std::string append_table(const Override& change, toml::table& scene);

}  // namespace shatterpave::scene
