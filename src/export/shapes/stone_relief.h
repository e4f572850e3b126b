// The fractal surface that the stones of a pavement share, each with its own place in it: the same for every target.
#pragma once

#include <cstdint>

#include "paving/pavement.h"
#include "relief/fractal_surface.h"

namespace shatterpave::exporting::shapes {

// Root of the area of a whole stone's face.
double mean_size_mm(const paving::Pavement& pavement);

// What it is like. A period is about five stones wide.
relief::FractalSurface stone_relief(const paving::Pavement& pavement);

// Its heights, with the seed of the scene.
relief::HeightField stone_relief_heights(const paving::Pavement& pavement, std::uint64_t seed);

}  // namespace shatterpave::exporting::shapes
