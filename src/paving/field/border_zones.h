// Where rows of oblong stones follow the border and meet at an angle, they cannot bend into one another: they are mitred, as
// a paviour would. The zones are the parts between the mitres.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/region_index.h"

namespace shatterpave::paving {

struct BorderZones {
  std::vector<std::uint32_t> of_segment;             // the zone of each segment of the border
  std::vector<std::vector<geometry::Region>> areas;  // of each zone; together they are the region
};

// The zones of `region`, of which `border` is made. A zone is what lies nearest to a run of sides that bend gently into one
// another; runs that face each other with rows alike, as those of a path, share one. Runs shorter than `least_run_mm` go with a
// neighbour. One zone, of the whole region, if nothing is to be mitred.
BorderZones border_zones(const geometry::Region& region, const geometry::RegionIndex& border, double least_run_mm);

}  // namespace shatterpave::paving
