#include "export/textures/fields.h"

#include "export/shapes/stone_relief.h"

namespace shatterpave::exporting::textures {

Fields fields_of(const paving::Pavement& pavement, std::uint64_t seed) {
  constexpr std::size_t grain_size = 256;
  constexpr double spacing_mm = grain_side_mm / static_cast<double>(grain_size);
  const relief::FractalSurface shape = shapes::stone_relief(pavement);
  // Waves longer than eight points are level: grains, not dunes.
  const relief::FractalSurface grains{grain_size, spacing_mm, 1.0, 0.3, 8.0 * spacing_mm};
  return {shapes::stone_relief_heights(pavement, seed), shape.spacing_mm * static_cast<double>(shape.size),
          relief::fractal_surface(grains, seed, Id(pavement.name).child("grain"))};
}

}  // namespace shatterpave::exporting::textures
