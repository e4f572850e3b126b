// The job of `export`, whichever targets it is for.
#pragma once

#include <functional>
#include <vector>

#include "cli/arguments.h"
#include "export/target.h"
#include "scene/scene.h"

namespace shatterpave::cli {

// Throws InputError where a target would be refused for what the scene says, which is known before anything is made.
void require_for_targets(const scene::Scene& scene, const Targets& targets);

// Adds the files of a target to those of others.
using AppendTarget = std::function<void(const exporting::Target&, const exporting::Model&, exporting::Outputs&)>;

// Generates the scene and writes the files of all its targets.
void export_scene(const Export& job, const AppendTarget& append);

}  // namespace shatterpave::cli
