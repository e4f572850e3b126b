// The job of `export`, whichever targets it is for.
#pragma once

#include <functional>
#include <vector>

#include "cli/arguments.h"
#include "export/model.h"
#include "scene/scene.h"

namespace shatterpave::cli {

// Adds the files of a target.
using AppendTarget = std::function<void(const exporting::Model&, Target, exporting::Outputs&)>;

// Throws InputError where a target would be refused for what the scene says, which is known before anything is made.
void require_for_targets(const scene::Scene& scene, const std::vector<Target>& targets);

// JSON, SVG and OBJ.
void append_without_rasters(const exporting::Model& model, Target target, exporting::Outputs& outputs);

// Generates the scene and writes the files of all its targets.
void export_scene(const Export& job, const AppendTarget& append_target);

}  // namespace shatterpave::cli
