// How much of an area its stones cover, and where one is missing.
#pragma once

#include <vector>

#include "geometry/region_index.h"
#include "measure/stone_index.h"
#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::measure {

struct Coverage {
  double share = 1.0;       // of the area that lies under the stones grown by half a joint
  std::vector<vec2> holes;  // middles of the places where a stone is missing
};

// A stone is missing where a disc as wide as a quarter of a stone's shorter side fits between the grown stones: the smallest
// piece that is laid as a stone of its own, a quarter of one, is as wide. Where sizes follow a field, it is the smallest stone.
//   index   of the layout
//   area    of the pavement
Coverage coverage_of(const paving::Pavement& pavement, const paving::StoneLayout& layout, const StoneIndex& index,
                     const geometry::RegionIndex& area);

}  // namespace shatterpave::measure
