// Which of the shapes of a file is meant.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/outline_file.h"

namespace shatterpave::scene {

// The index of the shape that is chosen, or of the only one. `ids` are the ids of the shapes, "" where one has none; `what` is
// what such a shape is called. Throws InputError that lists the shapes.
std::size_t chosen_shape(const std::vector<std::string>& ids, std::string_view what, const OutlineChoice& choice,
                         const std::string& file);

}  // namespace shatterpave::scene
