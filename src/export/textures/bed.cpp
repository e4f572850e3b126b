#include "export/textures/bed.h"

#include <algorithm>
#include <cmath>

#include "export/textures/fields.h"
#include "paving/stone_surface.h"

namespace shatterpave::exporting::textures {

namespace {

// Root mean square of the sand's height: of grains up to 2 mm, as jointing sand has them (by eye), but no more than a flat bed
// leaves below the edges of the stones.
constexpr double sand_rms_mm = 0.3;
constexpr double part_of_level = 0.4;

vec2 whole_repeats(vec2 size_mm) {
  return {std::max(1.0, std::round(size_mm.x / grain_side_mm)), std::max(1.0, std::round(size_mm.y / grain_side_mm))};
}

}  // namespace

Bed::Bed(const paving::Pavement& pavement, const relief::HeightField& grains, const PixelGrid& grid, double sampled_mm)
    : grain_(grains, sampled_mm),
      repeats_(whole_repeats(grid.size_mm())),
      level_mm_(static_cast<float>(paving::bed_level_mm(pavement.surface))),
      grain_mm_(static_cast<float>(std::min(sand_rms_mm, part_of_level * paving::bed_level_mm(pavement.surface)))) {}

}  // namespace shatterpave::exporting::textures
