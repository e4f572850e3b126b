// Corners so sharp that their two sides run together on the lattice long before they meet.
#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::geometry {

// The region less 2 µm about the sides of each needle that reaches into it: a tip of a hole, or a notch, of less than 0.001
// rad. Cut across, such a tip would vanish, and what is cut would lie over it. The region itself where there is none, or where
// less of it would fall apart.
Region without_needles(const Region& region);

// The regions less what is narrower than `width_mm`, > 0: spikes, of which up to half the width is left at the root, and necks,
// at which a region is parted. Those without stay as they are; so do sides away from a spike. Sides of parted ones are rounded
// anew, by 1 µm at the most.
std::vector<Region> without_slivers(const std::vector<Region>& regions, double width_mm);

}  // namespace shatterpave::geometry
