// Fractal surface: the micro relief of stone (§4 (2) of Miyata and Itoh), by spectral synthesis.
//
// Heights are a periodic Gaussian field whose two-dimensional power spectrum falls as k^−(2H + 2) (Saupe in "The Science of
// Fractal Images", 1988, §2.4), with H the Hurst exponent. Below the wave number of `longest_mm` the spectrum is level, so
// that a window of that size shows the whole rms height, and windows next to one another do not lie at different levels.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/random.h"
#include "relief/height_field.h"

namespace shatterpave::relief {

struct FractalSurface {
  std::size_t size = 1024;    // points along a side, a power of two from 2 to 8192
  double spacing_mm = 0.5;    // between points, > 0
  double rms_mm = 0.6;        // root mean square of the height, exactly; >= 0
  double hurst = 0.7;         // 0 … 1
  double longest_mm = 100.0;  // wavelength from which on the spectrum is level, > 0
};

// The surface `element` with that seed: the same to the bit for any number of threads. Its mean is 0.
HeightField fractal_surface(const FractalSurface& surface, std::uint64_t seed, Id element);

}  // namespace shatterpave::relief
