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

// Patches of damp and of what was swept in are this much larger than grains; by eye.
constexpr double patch_scale = 12.0;

vec2 whole_repeats(vec2 size_mm, double side_mm) {
  return {std::max(1.0, std::round(size_mm.x / side_mm)), std::max(1.0, std::round(size_mm.y / side_mm))};
}

}  // namespace

Bed::Bed(const paving::Pavement& pavement, const relief::HeightField& grains, const PixelGrid& grid, double sampled_mm)
    : grains_(grains, sampled_mm),
      patches_(grains, sampled_mm / patch_scale),
      grain_repeats_(whole_repeats(grid.size_mm(), grain_side_mm)),
      patch_repeats_(whole_repeats(grid.size_mm(), patch_scale * grain_side_mm)),
      level_mm_(static_cast<float>(paving::bed_level_mm(pavement))),
      grain_mm_(static_cast<float>(std::min(sand_rms_mm, part_of_level * paving::bed_level_mm(pavement)))) {}

}  // namespace shatterpave::exporting::textures
