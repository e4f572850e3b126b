// Radix-2 transform (Cooley and Tukey 1965): bit reversal, then butterflies of doubling length. A library's would be faster,
// but chooses its code by what the processor can do, and so differs in the last bit between machines.
#include "relief/fourier.h"

#include <bit>
#include <span>
#include <utility>

#include "core/cancel.h"
#include "core/error.h"
#include "core/functions.h"
#include "core/parallel.h"

namespace shatterpave::relief {

namespace {

using Complex = std::complex<double>;

// std::complex's own product asks after infinities; there are none here.
Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

// exp(2πi k / size) for the first half of the circle.
std::vector<Complex> roots_of_unity(std::size_t size) {
  std::vector<Complex> roots(size / 2);
  for (std::size_t k = 0; k < roots.size(); ++k) {
    const double angle = 2.0 * pi * static_cast<double>(k) / static_cast<double>(size);
    roots[k] = {cosine(angle), sine(angle)};
  }
  return roots;
}

void reverse_bits(std::span<Complex> values) {
  for (std::size_t i = 1, j = 0; i < values.size(); ++i) {
    std::size_t bit = values.size() >> 1U;
    for (; (j & bit) != 0; bit >>= 1U) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(values[i], values[j]);
  }
}

void transform_row_back(std::span<Complex> values, std::span<const Complex> roots) {
  reverse_bits(values);
  for (std::size_t length = 2; length <= values.size(); length *= 2) {
    const std::size_t step = values.size() / length;
    for (std::size_t start = 0; start < values.size(); start += length) {
      for (std::size_t k = 0; k < length / 2; ++k) {
        const Complex low = values[start + k];
        const Complex high = product(values[start + k + length / 2], roots[k * step]);
        values[start + k] = low + high;
        values[start + k + length / 2] = low - high;
      }
    }
  }
}

void transform_rows_back(std::vector<Complex>& field, std::size_t size, std::span<const Complex> roots) {
  parallel_for(size, [&](std::size_t row) { transform_row_back(std::span(field).subspan(row * size, size), roots); });
}

void transpose(std::vector<Complex>& field, std::size_t size) {
  for (std::size_t row = 0; row < size; ++row) {
    stop_if_cancelled();
    for (std::size_t column = 0; column < row; ++column) std::swap(field[row * size + column], field[column * size + row]);
  }
}

}  // namespace

void transform_back(std::vector<Complex>& spectrum, std::size_t size) {
  ENSURE(std::has_single_bit(size) && spectrum.size() == size * size);
  const std::vector<Complex> roots = roots_of_unity(size);
  transform_rows_back(spectrum, size, roots);
  transpose(spectrum, size);
  transform_rows_back(spectrum, size, roots);
  transpose(spectrum, size);
}

}  // namespace shatterpave::relief
