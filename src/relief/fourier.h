// Discrete Fourier transform of square periodic fields.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace shatterpave::relief {

// The inverse transform, without a factor: field[x, y] = Σ spectrum[k, l] exp(2πi (kx + ly) / size), row by row, in place.
//   spectrum  size * size values
//   size      a power of two
void transform_back(std::vector<std::complex<double>>& spectrum, std::size_t size);

}  // namespace shatterpave::relief
