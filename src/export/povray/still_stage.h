// The camera and the light of a scene, as POV-Ray has them.
#pragma once

#include <optional>
#include <string>

#include "core/angle.h"
#include "export/model.h"
#include "relief/raster.h"

namespace shatterpave::exporting::povray {

// The picture of all around, in focus, and how far it is to be out of it.
struct SkyPicture {
  std::string name;
  relief::Raster sharp;
  Angle blur;
};

// What stands in a still for its own camera and light.
struct StillStage {
  bool has_camera = false;          // whether `declarations` hold Still_Camera(Shift, Turn)
  bool has_light = false;           // and Still_Light(Turn)
  std::string declarations;         // macros, to be declared before the first of them is used
  std::optional<SkyPicture> sky{};  // that they read
};

// Still_Camera(Shift, Turn) is the camera, Still_Light(Turn) the lights and the sky: for a still in which the point P of the
// world stands at vrotate(P, Turn) + Shift, Turn being about y. The world's (x, y, z) is POV-Ray's <x, z, y>. Both are declared
// where the model has them; where `always`, also what the things ask for (export/shapes/stage.h).
//
// The environment is the sky, and lights by far lights (environment_lights.h), fewer of them in a draft.
StillStage still_stage(const Model& model, bool always);

// The picture is written anew, in half floats, since POV-Ray's reader knows fewer kinds than one may bring.
OutputFile sky_file(const SkyPicture& sky);

}  // namespace shatterpave::exporting::povray
