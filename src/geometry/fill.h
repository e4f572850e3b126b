// The area that closed rings fill, even where they cross, touch or run along each other.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::geometry {

// The rule that says what is filled: the points that rings wind round at all, or an odd number of times (SVG 1.1, 11.3).
enum class FillRule { nonzero, evenodd };

// Thrown for rings that cross so often that filling them would take all time and memory.
inline constexpr std::size_t most_crossings = 1'000'000;
class TooManyCrossings : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The regions that rings fill together. Rings may cross, touch and run along each other and themselves; each winds as it is
// given.
//   REQUIRES  coordinates within `largest_coordinate_mm`
// 1. No result has a `region_fault`, and no two have more than single points in common: sides are rounded to the lattice
//    together (see fill.cpp), never one by one.
// 2. A side strays by less than 1 µm from the one it came from. Parts and holes that are thinner than that are left out.
// 3. Regions are in the order of their leftmost vertices; their vertices are those of the rings, and where sides cross.
// Throws TooManyCrossings.
std::vector<Region> filled(const std::vector<Polygon>& rings, FillRule rule);

// The area that `outline` fills, without what each of `holes` fills by itself; otherwise as `filled`.
std::vector<Region> filled_without(const Polygon& outline, const std::vector<Polygon>& holes, FillRule rule);

// The same areas as regions of which 1. holds: as they are if none of them has a `region_fault`, else filled anew. For results
// of clipping, whose sides may cross where they were rounded.
std::vector<Region> without_faults(std::vector<Region> regions);

}  // namespace shatterpave::geometry
