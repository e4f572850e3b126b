// The bodies of a broken pane.
//
// Without shards it is a slab with cavities: the slab's surface looks outwards, the walls of cracks look into them, so that all
// together bound the glass. Cracks are gaps of two walls, or tubes of six sides, as the pane asks for; each is a body of its
// own name. With shards each shard that is not missing is a body, about its own middle.
#pragma once

#include "export/shapes/bodies.h"

namespace shatterpave::exporting::shapes {

//   first_material  of the pane's three
void append_glass(const BrokenPane& broken, std::size_t first_material, const TakeBody& take);

}  // namespace shatterpave::exporting::shapes
