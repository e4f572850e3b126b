// The job of `export`, whichever targets it is for.
#pragma once

#include <functional>

#include "cli/arguments.h"
#include "export/model.h"

namespace shatterpave::cli {

// Adds the files of a target.
using AppendTarget = std::function<void(const exporting::Model&, Target, exporting::Outputs&)>;

// JSON and SVG.
void append_without_rasters(const exporting::Model& model, Target target, exporting::Outputs& outputs);

// Generates the scene and writes the files of all its targets.
void export_scene(const Export& job, const AppendTarget& append_target);

}  // namespace shatterpave::cli
