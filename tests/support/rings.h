// Rings of polygons, for tests.
#pragma once

#include <algorithm>

#include "geometry/polygon.h"

namespace shatterpave::support {

// The other way round.
inline geometry::Polygon reversed(geometry::Polygon ring) {
  std::ranges::reverse(ring);
  return ring;
}

}  // namespace shatterpave::support
