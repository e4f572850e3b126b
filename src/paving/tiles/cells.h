// A division of the plane into closed regions, one for each stone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::paving {

// The straight side of a stone departs from the border between cells by this part of a joint at most, where stones of a bent
// row lie shifted against those of the next: so much may a joint between straight sides be wider or narrower in its middle.
// By trial: with less, more stones about sharp bends have five corners.
inline constexpr double largest_bulge = 0.2;

// Cells share their corners to the bit where neighbours do, so that they neither overlap nor leave a gap. Those that have no
// end, at the rim of a packing, are empty.
struct Cells {
  std::vector<vec2> corners;             // on the lattice
  std::vector<std::size_t> first;        // sides of cell i are [first[i], first[i + 1])
  std::vector<std::uint32_t> corner;     // of a side, where it begins; counter-clockwise
  std::vector<std::uint32_t> neighbour;  // of a side, the cell beyond it; empty where cells do not share corners
  std::vector<vec2> axis;                // of a cell: unit vector along its stone

  // Of a cell, the size of its stone as a part of the one that is asked for. Empty where all are 1.
  std::vector<double> size;

  // Of a side, whether its first corner lies on the straight line between the one before and the next, where two neighbours
  // meet, and is left out of the outline. Empty where there are none.
  std::vector<bool> left_out;
  // Of a side, whether its first corner lies so near to that line that the stone is laid without it, though the cell is not.
  // Empty where there are none.
  std::vector<bool> bulging;
  // Of a cell, whether it is no more than a part of a stone. Empty where all are whole.
  std::vector<bool> part;

  std::size_t count() const { return first.size() - 1; }
  double size_of(std::size_t cell) const { return size.empty() ? 1.0 : size[cell]; }
  geometry::Polygon outline(std::size_t cell) const;
  std::span<const std::uint32_t> neighbours(std::size_t cell) const {
    return {neighbour.data() + first[cell], first[cell + 1] - first[cell]};
  }
};

}  // namespace shatterpave::paving
