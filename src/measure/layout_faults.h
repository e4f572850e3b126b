// What must not be at all in a layout of stones: exact, on the lattice.
#pragma once

#include <cstddef>

#include "geometry/region_index.h"
#include "measure/stone_index.h"
#include "paving/stones.h"

namespace shatterpave::measure {

struct LayoutFaults {
  std::size_t invalid = 0;   // outline not simple, not counter-clockwise, with repeated or redundant vertices, off the lattice
  std::size_t overlaps = 0;  // pairs of stones with a point in common
  std::size_t outside = 0;   // stones that leave the area or enter a hole

  std::size_t total() const { return invalid + overlaps + outside; }
  bool operator==(const LayoutFaults&) const = default;
};

// `index` is of the layout, `area` of its pavement. Time goes with the number of stones where they lie side by side.
LayoutFaults layout_faults(const paving::StoneLayout& layout, const StoneIndex& index, const geometry::RegionIndex& area);

}  // namespace shatterpave::measure
