// The whole program in memory: from a scene to what every exporter needs. No file is touched.
#pragma once

#include "core/progress.h"
#include "export/model.h"
#include "scene/scene.h"

namespace shatterpave::pipeline {

exporting::Model generated(const scene::Scene& scene, const Progress& progress = {});

}  // namespace shatterpave::pipeline
