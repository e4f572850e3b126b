// The border of the hole of one impact: arcs that bulge into the glass that stays, and cusps between them.
#pragma once

#include <cstdint>

#include "core/random.h"
#include "geometry/polygon.h"
#include "glass/network.h"

namespace shatterpave::glass {

// 6 to 12 arcs, of widths by lot, about the centre, counter-clockwise; a simple polygon that may reach beyond the pane. Where
// two arcs meet, glass points inwards with a cusp of 20 to 60°. Most cusps are daggers: one flank is a radial crack, along
// which the piece beside it has left, the other the end of an arc. Where no radial is near, both flanks are arcs, and the cusp
// leans to one side.
//   radius_mm  above 0; the hole is about as large as a disc of it
geometry::Polygon hole_border(const CrackNetwork& network, vec2 centre, double radius_mm, std::uint64_t seed, Id id);

}  // namespace shatterpave::glass
