#include "paving/tiles/tiling.h"

#include "geometry/lattice.h"

namespace shatterpave::paving {

Cells cells_of(const std::vector<Tile>& tiles) {
  Cells cells;
  cells.first.push_back(0);
  for (const Tile& tile : tiles) {
    for (const vec2& p : tile.outline_mm) {
      cells.corner.push_back(static_cast<std::uint32_t>(cells.corners.size()));
      cells.corners.push_back(geometry::on_lattice(p));
    }
    cells.first.push_back(cells.corner.size());
    cells.axis.push_back(tile.axis);
    cells.part.push_back(tile.cut);
  }
  return cells;
}

}  // namespace shatterpave::paving
