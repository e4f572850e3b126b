// The whole program in memory: from a scene to what every exporter needs. No file is touched.
#pragma once

#include <cstddef>
#include <functional>

#include "core/progress.h"
#include "export/model.h"
#include "export/target.h"
#include "scene/scene.h"

namespace shatterpave::pipeline {

// Throws InputError for what `generated` would refuse, as far as that can be told without making anything. `check` calls this
// once it has read the file.
void require_possible(const scene::Scene& scene);

// The same for what a target would refuse of the scene.
void require_possible_for(const exporting::Target& target, const scene::Scene& scene);

// The things of a model, panes first, are numbered from 0 in its order. Those that are not wanted are as the scene asks for
// them, with nothing made of them.
using Wanted = std::function<bool(std::size_t thing)>;
exporting::Model generated(const scene::Scene& scene, const Wanted& wanted, const Progress& progress = {});
exporting::Model generated(const scene::Scene& scene, const Progress& progress = {});

}  // namespace shatterpave::pipeline
