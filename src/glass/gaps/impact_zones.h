// What an impact takes of the pane before its cracks begin: a zone without gaps, and the hole of what went through.
#pragma once

#include <cstddef>
#include <cstdint>

#include "glass/gaps/crack_surface.h"
#include "glass/gaps/crack_walls.h"
#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// Adds the zone of each impact of the network, and the holes, each within its zone.
void add_zones(const Pane& pane, const CrackNetwork& network, std::uint64_t seed, CrackSurfaces& result);

// Leaves those of the first `impacts` of the network alone.
void leave_out_later(std::size_t impacts, CrackSurfaces& surfaces);

// What the cracks of an impact start from: the rim of its zone, or the wall of its hole. The barrier holds no reference.
Barrier rim_of(const CrackSurfaces& impacts, const ImpactZone& zone);

}  // namespace shatterpave::glass
