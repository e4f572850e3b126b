// The direction of the rows at every place of a pavement (§3 of Miyata and Itoh: "the vector field that the particles line
// up with").
#pragma once

#include "core/angle.h"
#include "geometry/region_index.h"
#include "paving/pavement.h"

namespace shatterpave::paving {

class DirectionField {
 public:
  DirectionField(const Direction& direction, const geometry::RegionIndex& area);

  // Unit vector along the rows at `place`, which may lie outside the area. Its sign means nothing.
  vec2 axis(vec2 place) const;
  // The same as an angle in (−90°, 90°].
  Angle angle(vec2 place) const;

 private:
  Direction direction_;
  const geometry::RegionIndex* area_;
};

}  // namespace shatterpave::paving
