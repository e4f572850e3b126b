// The bodies of a pavement: its stones, what fills the joints, and water that stands on them.
//
// A stone is its upper surface and its sides, down to below the filling; it is open where it stands on its bed. Places in
// textures run along the stone's axis in metres, and begin somewhere else on each: a texture that repeats after a metre shows
// another part of itself on stones that lie side by side.
#pragma once

#include "export/shapes/bodies.h"

namespace shatterpave::exporting::shapes {

//   first_material  of the pavement's stone_materials + 2
//   seed            of the scene
void append_stones(const PavedArea& paved, std::size_t first_material, std::uint64_t seed, const TakeBody& take);

}  // namespace shatterpave::exporting::shapes
