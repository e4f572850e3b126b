#include "pipeline/environment.h"

#include <fmt/format.h>

#include "core/error.h"
#include "relief/panorama.h"

namespace shatterpave::pipeline {

void require_environment(const scene::Scene& scene) {
  if (!scene.environment) return;
  try {
    relief::panorama(*scene.environment->content, scene.environment->ending);
  } catch (const InputError& error) {
    throw InputError(scene.environment_place, fmt::format("{}: {}", scene.light->environment, error.message()));
  }
}

}  // namespace shatterpave::pipeline
