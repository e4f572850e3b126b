// The environment of a scene, which is a picture: looked at where pictures are read.
#pragma once

#include "scene/scene.h"

namespace shatterpave::pipeline {

// Throws InputError, at the key that names it, where the scene's environment is no picture that targets can take: beside what
// `require_possible` looks for. To be asked before anything is made of a scene with an environment.
void require_environment(const scene::Scene& scene);

}  // namespace shatterpave::pipeline
