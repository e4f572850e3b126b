// Stones rolled out flat, for places in textures: a sheet that is laid on the face and folded down over the arrises, which is
// drawn out nowhere but at rounded corners, that no sheet covers.
#pragma once

#include <vector>

#include "export/shapes/stone_mesh.h"

namespace shatterpave::exporting::shapes {

// For each vertex of a displaced mesh its place on the sheet, mm: on the face where it is seen from above.
std::vector<vec2> unrolled(const StoneMesh& mesh);

}  // namespace shatterpave::exporting::shapes
