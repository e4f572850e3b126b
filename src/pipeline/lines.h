// Panes whose cracks came from elsewhere, as a scene to measure.
#pragma once

#include <filesystem>

#include "scene/scene.h"

namespace shatterpave::pipeline {

// Whether the file's name says that it holds geometry or a drawing: .json or .svg.
bool is_file_of_lines(const std::filesystem::path& file);

// A scene with the panes of that file (scene/cracks_file.h), each with its cracks as given. Where a drawing has no outline,
// that is the box about its lines; where the file tells no impact, it is where most lines look at. Throws InputError for a file
// that cannot be read, and where no impact can be found.
scene::Scene scene_of_lines(const std::filesystem::path& file);

}  // namespace shatterpave::pipeline
