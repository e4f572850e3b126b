// The job of `export`, whichever targets it is for.
#pragma once

#include <functional>
#include <vector>

#include "cli/arguments.h"
#include "export/model.h"

namespace shatterpave::cli {

using FilesOfTarget = std::function<std::vector<exporting::OutputFile>(const exporting::Model&, Target)>;

// JSON and SVG.
std::vector<exporting::OutputFile> files_without_rasters(const exporting::Model& model, Target target);

// Generates the scene and writes the files of all its targets.
void export_scene(const Export& job, const FilesOfTarget& files_of_target);

}  // namespace shatterpave::cli
