// Tangents, which normal maps are read along.
#pragma once

#include <vector>

#include "export/shapes/body.h"

namespace shatterpave::exporting::shapes {

struct Tangent {
  vec3 along{1.0, 0.0, 0.0};  // unit, at right angles to the normal: the way in which u grows
  bool is_mirrored = false;   // whether v grows against cross(normal, along)
};

// One for each point: the mean of those of its triangles by their area in the texture.
std::vector<Tangent> tangents(const Mesh& mesh);

}  // namespace shatterpave::exporting::shapes
