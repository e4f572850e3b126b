// The whole program in memory: from a scene to what every exporter needs. No file is touched.
#pragma once

#include "core/progress.h"
#include "export/model.h"
#include "export/target.h"
#include "scene/scene.h"

namespace shatterpave::pipeline {

// Throws InputError where what `generated` would refuse can be told without making it: what `check` looks for beyond the file
// itself.
void require_possible(const scene::Scene& scene);

// The same for what a target would refuse of the scene.
void require_possible_for(const exporting::Target& target, const scene::Scene& scene);

exporting::Model generated(const scene::Scene& scene, const Progress& progress = {});

}  // namespace shatterpave::pipeline
