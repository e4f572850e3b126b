// The picture of all around (export/shapes/stage.h), for targets that show it. Such a target stands in
// export/raster_targets.cpp.
#pragma once

#include "export/model.h"
#include "export/shapes/stage.h"
#include "relief/raster.h"

namespace shatterpave::exporting::swatches {

// It as the scene's file holds it, linear; and as far out of focus as the scene's light says.
relief::Raster sharp_environment(const shapes::Stage& stage);
relief::Raster seen_environment(const shapes::Stage& stage);

// Adds the picture under the stage's name for it, unless a target before has: the very file that the scene names, where it is
// in focus.
void append_environment(const shapes::Stage& stage, Outputs& outputs);

}  // namespace shatterpave::exporting::swatches
