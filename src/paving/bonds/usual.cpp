#include "paving/bonds/usual.h"

#include <algorithm>

#include "paving/bonds/bond.h"
#include "paving/bonds/table.h"
#include "paving/tiles/cutting.h"

namespace shatterpave::paving {

double pitch_area_mm2(const Pavement& pavement) {
  const vec2 pitch = pitch_mm(pavement);
  return pitch.x * pitch.y;
}

double stone_face_mm2(const Pavement& pavement) { return pavement.stone_mm.x * pavement.stone_mm.y; }

Stock stock_of(vec2 size_mm) { return {size_mm, size_mm.x * size_mm.y, {}, {1.0, 0.0}}; }

Stock stone_stock(const Pavement& pavement) { return stock_of(pavement.stone_mm); }

Stock pattern_stock(const Pavement& pavement) {
  Stock largest;
  for (const Tile& tile : type_of(pavement).pattern(pavement).tiles) {
    for (const geometry::Polygon& face : faces_of(tile.outline_mm, pavement.joint_mm)) {
      largest.size_mm = glm::max(largest.size_mm, size_of(extent(face, tile.axis)));
      largest.area_mm2 = std::max(largest.area_mm2, geometry::area(face));
    }
  }
  return largest;
}

Placement placed(const Pavement& pavement, const Pattern& pattern, const geometry::RegionIndex& area) {
  Placement placement = anchored(area, pattern_direction(pavement).direction());
  if (pavement.bonding.start_mm) {
    placement.origin = vec2{0.0, 0.0};
    placement.origin = *pavement.bonding.start_mm - placement.out_of(pattern.tiles.front().outline_mm.front());
  }
  return placement;
}

std::vector<Tile> pattern_tiles(const Pavement& pavement, const geometry::RegionIndex& area, std::uint64_t /*seed*/) {
  const Pattern pattern = type_of(pavement).pattern(pavement);
  return repeated(pattern, placed(pavement, pattern, area), area);
}

double span_mm(const Pavement& pavement) {
  // Small setts of 8 to 10 cm are laid in segmental arcs 1 m to 1.5 m wide.
  constexpr double stones_to_a_span = 12.0;
  const double given = pavement.bonding.span_mm;
  return given > 0.0 ? given : stones_to_a_span * pitch_mm(pavement).x;
}

}  // namespace shatterpave::paving
