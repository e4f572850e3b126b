// The widest place that stones leave bare.
#pragma once

#include "geometry/inscribed_circle.h"
#include "geometry/region_index.h"
#include "measure/stone_index.h"
#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::measure {

// The widest disc in what is bare when every stone is grown by half a joint, with its corners, and the half joint along the
// border is left out; of radius 0 where nothing is bare. Exact to `geometry::circle_tolerance_mm`, but for corners sharper than
// 23°, whose tips are cut off. Time goes with the number of stones.
//   index   of the layout
//   area    of the pavement
geometry::Circle widest_bare_spot(const paving::Pavement& pavement, const paving::StoneLayout& layout, const StoneIndex& index,
                                  const geometry::RegionIndex& area);

// The widest bare spot that is let pass, mm: a tenth of the longest side that a stone has, of the bond or of the border course.
double widest_allowed_spot_mm(const paving::Pavement& pavement);

}  // namespace shatterpave::measure
