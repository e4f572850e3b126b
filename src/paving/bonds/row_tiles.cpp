#include "paving/bonds/row_tiles.h"

#include "geometry/corners.h"
#include "paving/bonds/bond.h"
#include "paving/bonds/courses.h"
#include "paving/bonds/rings.h"
#include "paving/bonds/usual.h"

namespace shatterpave::paving {

Pattern rows_pattern(vec2 pitch, double offset) {
  return {pitch, offset, {{geometry::rectangle({{0.0, 0.0}, pitch}), along_u}}};
}

std::vector<Tile> row_tiles(const Pavement& pavement, double offset, const geometry::RegionIndex& area) {
  const vec2 pitch = pitch_mm(pavement);
  if (const auto* radial = std::get_if<RadialDirection>(&pavement.direction)) {
    return ring_tiles(pitch, *radial, pavement.bonding.start, offset, area);
  }
  if (is_bent(pavement)) return parallel_tiles(pavement, pitch, offset, area);
  const Pattern pattern = rows_pattern(pitch, offset);
  Placement placement = placed(pavement, pattern, area);
  placement.origin += pavement.bonding.start * pitch.x * placement.along;
  return repeated(pattern, placement, area);
}

}  // namespace shatterpave::paving
