#include "paving/tiles/cells.h"

namespace shatterpave::paving {

geometry::Polygon Cells::outline(std::size_t cell) const {
  geometry::Polygon polygon;
  polygon.reserve(first[cell + 1] - first[cell]);
  for (std::size_t side = first[cell]; side < first[cell + 1]; ++side) {
    if (left_out.empty() || !left_out[side]) polygon.push_back(corners[corner[side]]);
  }
  return polygon;
}

}  // namespace shatterpave::paving
