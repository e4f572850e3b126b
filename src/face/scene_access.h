// A scene of the face as the rooms read it.
#pragma once

#include <shatterpave/scene.h>

#include <memory>

#include "scene/scene.h"

namespace shatterpave {

class SceneAccess {
 public:
  // The scene, read again if it was changed since the last time. Throws InputError.
  static std::shared_ptr<const scene::Scene> read(const Scene& scene);
};

}  // namespace shatterpave
