#include "export/textures/bed.h"

#include <algorithm>
#include <cmath>

#include "export/textures/fields.h"
#include "paving/surface/stone_surface.h"

namespace shatterpave::exporting::textures {

namespace {

// Root mean square of the sand's height: of grains up to 2 mm, as jointing sand has them (by eye), but no more than a flat bed
// leaves below the edges of the stones.
constexpr double sand_rms_mm = 0.3;
constexpr double part_of_level = 0.4;

// Patches of damp and of what was swept in are this much larger than grains; by eye.
constexpr double patch_scale = 12.0;

vec2 repeats(vec2 size_mm, double side_mm, bool periodic) {
  const vec2 exact = size_mm / side_mm;
  return periodic ? glm::max(vec2{1.0, 1.0}, glm::round(exact)) : exact;
}

}  // namespace

Bed::Bed(const paving::Pavement& pavement, const relief::HeightField& grains, const PixelGrid& grid, bool periodic,
         double sampled_mm)
    : grains_(grains, sampled_mm),
      patches_(grains, sampled_mm / patch_scale),
      grain_repeats_(repeats(grid.size_mm(), grain_side_mm, periodic)),
      patch_repeats_(repeats(grid.size_mm(), patch_scale * grain_side_mm, periodic)),
      level_mm_(static_cast<float>(paving::bed_level_mm(pavement))),
      grain_mm_(static_cast<float>(std::min(sand_rms_mm, part_of_level * paving::bed_level_mm(pavement)))) {}

}  // namespace shatterpave::exporting::textures
