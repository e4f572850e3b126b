// Geometry as JSON, for scripts and other programs: the format "shatterpave-geometry" of docs/scene-file.md.
#pragma once

#include "export/target.h"

namespace shatterpave::exporting::json {

// One file, `NAME.json`. Numbers are the shortest that read back exactly; angles are rounded to 1e-6 degrees.
OutputFile json_file(const Model& model);

void append(const Model& model, Outputs& outputs);

inline constexpr Target target{
    .name = "json",
    .sentence = "all geometry, cracks, shards and stones, for scripts and other programs (SCENE.json)",
    .append = append};

}  // namespace shatterpave::exporting::json
