// Scenes fitted to traced panes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.h"

namespace shatterpave::pipeline {

// The text of a scene file whose panes could be those of the files (scene/cracks_file.h), with what was fitted, its errors and
// how well it fits in comments. Throws InputError for files that cannot be read.
std::string fitted_scene_text(const std::vector<std::filesystem::path>& traces, const Progress& progress = {});

// Writes that text to `file`, whole or not at all.
void write_fitted_scene(const std::vector<std::filesystem::path>& traces, const std::filesystem::path& file,
                        const Progress& progress = {});

}  // namespace shatterpave::pipeline
