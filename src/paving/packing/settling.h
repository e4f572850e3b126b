// Small movements of the corners of cells after packing: sides turn to the field and take the length of a stone.
#pragma once

#include <span>

#include "geometry/region_index.h"
#include "paving/packing/particle.h"
#include "paving/pavement.h"
#include "paving/tiles/cells.h"

namespace shatterpave::paving {

// The same cells with better corners:
//   - sides of stones lie along the field or across it and have the length of a pitch, as nearly as neighbours allow;
//   - where a row ends between two others, and beside such a place, a joint meets the straight side of a stone (a T), so that
//     this one keeps four corners; that corner is left out of its outline, or bulges by no more than `largest_bulge`;
//   - corners beside a border that runs along or across the rows lie on it.
// Every cell is simple and counter-clockwise where it was. They share their sides as before, but for the Ts that are left out,
// which lie on the side that they meet to the rounding of the lattice.
Cells settled_cells(Cells cells, std::span<const Particle> particles, const Pavement& pavement,
                    const geometry::RegionIndex& area);

}  // namespace shatterpave::paving
