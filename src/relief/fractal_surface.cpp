// Each wave vector gets a complex normal amplitude times the root of the spectrum; the real part of the inverse transform is
// the surface. Draws are by address (row of the spectrum, place in the row), so threads do not show.
#include "relief/fractal_surface.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <vector>

#include "core/error.h"
#include "core/functions.h"
#include "core/parallel.h"
#include "relief/fourier.h"

namespace shatterpave::relief {

namespace {

// Wave number of an index, in waves over the whole side: 0, 1, …, size/2, …, −2, −1.
double wave_number(std::size_t index, std::size_t size) {
  const auto k = static_cast<double>(index);
  return index <= size / 2 ? k : k - static_cast<double>(size);
}

// Root of the power spectrum at `waves` over the side, up to a factor.
double amplitude(double waves, double level_waves, double hurst) { return power(std::max(waves, level_waves), -(hurst + 1.0)); }

std::vector<std::complex<double>> spectrum(const FractalSurface& surface, std::uint64_t seed, Id element) {
  const std::size_t size = surface.size;
  const double level_waves = static_cast<double>(size) * surface.spacing_mm / surface.longest_mm;
  std::vector<std::complex<double>> values(size * size);
  parallel_for(size, [&](std::size_t row) {
    const Id row_id = element.child(row);
    const double l = wave_number(row, size);
    for (std::size_t column = 0; column < size; ++column) {
      const double k = wave_number(column, size);
      const double scale = amplitude(std::sqrt(k * k + l * l), level_waves, surface.hurst);
      const auto draw = static_cast<std::uint32_t>(2 * column);
      values[row * size + column] = {scale * normal(seed, {Stream::relief_lattice, row_id, draw}),
                                     scale * normal(seed, {Stream::relief_lattice, row_id, draw + 1})};
    }
  });
  values[0] = 0.0;  // the mean
  return values;
}

}  // namespace

HeightField fractal_surface(const FractalSurface& surface, std::uint64_t seed, Id element) {
  ENSURE(std::has_single_bit(surface.size) && surface.size >= 2 && surface.size <= 8192);
  ENSURE(surface.spacing_mm > 0.0 && surface.longest_mm > 0.0);
  ENSURE(surface.rms_mm >= 0.0 && surface.hurst >= 0.0 && surface.hurst <= 1.0);
  HeightField field{surface.size, surface.size, surface.spacing_mm, std::vector<double>(surface.size * surface.size, 0.0)};
  if (surface.rms_mm == 0.0) return field;

  std::vector<std::complex<double>> values = spectrum(surface, seed, element);
  transform_back(values, surface.size);
  std::ranges::transform(values, field.heights_mm.begin(), [](const std::complex<double>& value) { return value.real(); });
  const double scale = surface.rms_mm / rms_mm(field);
  for (double& height : field.heights_mm) height *= scale;
  return field;
}

}  // namespace shatterpave::relief
