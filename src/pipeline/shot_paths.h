// How things move over a shot, for targets that hold that in one file (export/target.h).
#pragma once

#include "export/model.h"
#include "scene/shot.h"

namespace shatterpave::pipeline {

// Gives the model of the shot's still the paths of its camera, and of the shards of those panes whose shards.time_s changes
// over the frames; nothing where neither moves. At a frame each is where the scene at that frame has it. Throws InputError, at
// the frames' range, beyond ten million places.
void add_paths(exporting::Model& model, scene::Shot& shot);

}  // namespace shatterpave::pipeline
