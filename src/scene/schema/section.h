// What [[pane]] and [[pavement]] have in common: a name and an outline.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "scene/schema/plan_section.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

// `name`: 1 to 64 of letters, digits, '_' and '-', the first a letter.
std::string name_of(const TomlTable& table);

// The regions, one or more, that `size_mm`, or `outline_mm` with `holes_mm`, or `outline_file` gives. `default_size_mm` is a
// rectangle for where none of them is given.
std::vector<geometry::Region> outlines_of(const TomlTable& table, Plans& plans,
                                          std::optional<vec2> default_size_mm = std::nullopt);

}  // namespace shatterpave::scene
