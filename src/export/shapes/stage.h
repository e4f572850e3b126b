// How the things of a model are seen and lit in mesh targets: as the scene says, or else as its things ask for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "export/model.h"
#include "export/shapes/body.h"
#include "studio/camera.h"
#include "studio/environment.h"
#include "studio/light.h"

namespace shatterpave::exporting::shapes {

struct Stage {
  studio::Camera camera;                    // in the world
  std::vector<studio::Camera> camera_path;  // at each frame of the model's shot; empty: it stays
  studio::Light light;                      // exposure not yet in its gains
  studio::Environment environment;          // in focus: the picture that the scene names, or a plain sky
  std::string
      environment_name;  // of its file beside the target's: SCENE_environment.ENDING; out of focus another, always of EXR
};

// Without a camera of its own, a model is seen whole, with a margin: panes from before the side that is hit, or from before −y
// where they look to all sides; pavements alone from above, obliquely. Without a light of its own it is lit by a plain sky and
// a sun that stands to the left behind the camera.
Stage stage_of(const Model& model);

// Of a camera, or of light that shines along its view: from axes x right, y up, −z forward to the frame of the bodies.
Placing placing_of(const studio::Camera& camera);
// At each frame of the model's shot, each there; empty where the camera stays.
std::vector<std::optional<Placing>> camera_placings(const Stage& stage);
// Of the sun; where it stands makes no difference.
Placing placing_of(const studio::Sun& sun);

// Places that the things of the model keep within, in the world: the convex hull of these holds them.
std::vector<vec3> extents_mm(const Model& model);

}  // namespace shatterpave::exporting::shapes
