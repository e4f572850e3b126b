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

// Waves over the whole side that an index stands for, without their sign: 0, 1, …, size/2, …, 2, 1.
std::size_t waves(std::size_t index, std::size_t size) { return std::min(index, size - index); }

// Root of the power spectrum at `waves` over the side, up to a factor.
double amplitude(double waves, double level_waves, double hurst) { return power(std::max(waves, level_waves), -(hurst + 1.0)); }

// Amplitudes are the same in all octants, so that one has them all: for (k, l) with 0 <= l <= k <= size / 2.
std::size_t octant_index(std::size_t k, std::size_t l) { return k * (k + 1) / 2 + l; }

std::vector<double> octant_amplitudes(std::size_t size, double level_waves, double hurst) {
  const std::size_t count = size / 2 + 1;
  std::vector<double> amplitudes(octant_index(count, 0));
  parallel_for(count, [&](std::size_t k) {
    for (std::size_t l = 0; l <= k; ++l) {
      amplitudes[octant_index(k, l)] = amplitude(std::sqrt(static_cast<double>(k * k + l * l)), level_waves, hurst);
    }
  });
  return amplitudes;
}

std::vector<std::complex<double>> spectrum(const FractalSurface& surface, std::uint64_t seed, Id element) {
  const std::size_t size = surface.size;
  const double level_waves = static_cast<double>(size) * surface.spacing_mm / surface.longest_mm;
  const std::vector<double> amplitudes = octant_amplitudes(size, level_waves, surface.hurst);
  std::vector<std::complex<double>> values(size * size);
  parallel_for(size, [&](std::size_t row) {
    const Id row_id = element.child(row);
    const std::size_t l = waves(row, size);
    for (std::size_t column = 0; column < size; ++column) {
      const std::size_t k = waves(column, size);
      const double scale = amplitudes[octant_index(std::max(k, l), std::min(k, l))];
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
