// Turns as quaternions, which formats want in place of matrices.
#pragma once

#include <array>

#include "export/shapes/body.h"

namespace shatterpave::exporting::shapes {

// Of the turn, which is a rotation: x, y, z, w, of unit length.
std::array<double, 4> quaternion(const Placing& placing);

}  // namespace shatterpave::exporting::shapes
