// The shards of panes as Wavefront OBJ, which Blender, Houdini and others read.
#pragma once

#include <vector>

#include "export/model.h"

namespace shatterpave::exporting {

// `SCENE.obj` and its materials `SCENE.mtl`. Each shard that is not missing is an object and a group `PANE.ID`, where it is
// now; its faces are in the materials glass_old and glass_broken. 1 unit = 1 mm, x to the right, y up, z towards the viewer;
// outward faces are counter-clockwise. Pavements are left out. Throws InputError where no pane has shards.
std::vector<OutputFile> obj_files(const Model& model);

}  // namespace shatterpave::exporting
