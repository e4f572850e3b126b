#include "export/shapes/stone_relief.h"

#include <cmath>

namespace shatterpave::exporting::shapes {

namespace {

constexpr std::size_t relief_size = 1024;

// Points of the relief on a stone: as many as a stone takes pixels in a close view, so that the image is about five stones
// wide. By eye: with 100 a stone at the feet of the viewer looks smooth.
constexpr double relief_points_on_stone = 200.0;

}  // namespace

double mean_size_mm(const paving::Pavement& pavement) { return std::sqrt(pavement.stone_mm.x * pavement.stone_mm.y); }

relief::FractalSurface stone_relief(const paving::Pavement& pavement) {
  return {relief_size, mean_size_mm(pavement) / relief_points_on_stone, pavement.relief.rms_mm, pavement.relief.hurst,
          mean_size_mm(pavement)};
}

relief::HeightField stone_relief_heights(const paving::Pavement& pavement, std::uint64_t seed) {
  return relief::fractal_surface(stone_relief(pavement), seed, Id(pavement.name).child("relief"));
}

}  // namespace shatterpave::exporting::shapes
