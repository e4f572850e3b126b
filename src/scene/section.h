// What [[pane]] and [[pavement]] have in common: a name and an outline.
#pragma once

#include <optional>
#include <string>

#include "geometry/lattice.h"
#include "geometry/polygon.h"
#include "scene/toml_table.h"

namespace shatterpave::scene {

inline constexpr Range coordinate_range{-geometry::largest_coordinate_mm, geometry::largest_coordinate_mm};

// `name`: 1 to 64 of letters, digits, '_' and '-', the first a letter.
std::string name_of(const TomlTable& table);

// The region that `size_mm`, or `outline_mm` with `holes_mm`, or `outline_file` gives. `default_size_mm` is a rectangle for
// where none of them is given.
geometry::Region outline_of(const TomlTable& table, std::optional<vec2> default_size_mm = std::nullopt);

}  // namespace shatterpave::scene
