// Geometry as JSON, for scripts and other programs: the format "shatterpave-geometry" of docs/scene-file.md.
#pragma once

#include "export/model.h"

namespace shatterpave::exporting {

// One file, `NAME.json`. Numbers are the shortest that read back exactly; angles are rounded to 1e-6 degrees.
OutputFile json_file(const Model& model);

}  // namespace shatterpave::exporting
