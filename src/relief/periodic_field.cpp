#include "relief/periodic_field.h"

#include <bit>

#include "core/error.h"
#include "core/parallel.h"

namespace shatterpave::relief {

namespace {

constexpr std::size_t least_size = 4;
constexpr std::size_t largest_size = 4096;
// By eye: with fewer points than that to a step they show as facets, with more they make noise.
constexpr double most_steps = 1.5;

constexpr std::size_t rows_at_once = 64;

// Every second point of every second row, after the binomial filter 1 2 1.
std::vector<float> halved(const std::vector<float>& field, std::size_t size) {
  const std::size_t half = size / 2;
  std::vector<float> result(half * half);
  parallel_for_chunks(half, rows_at_once, [&](std::size_t begin, std::size_t end) {
    std::vector<float> mixed(size);
    for (std::size_t row = begin; row < end; ++row) {
      const float* above = &field[(2 * row + size - 1) % size * size];
      const float* here = &field[2 * row * size];
      const float* below = &field[(2 * row + 1) % size * size];
      for (std::size_t x = 0; x < size; ++x) mixed[x] = 0.25F * (above[x] + below[x]) + 0.5F * here[x];
      for (std::size_t x = 0; x < half; ++x) {
        result[row * half + x] = 0.25F * (mixed[(2 * x + size - 1) % size] + mixed[(2 * x + 1) % size]) + 0.5F * mixed[2 * x];
      }
    }
  });
  return result;
}

// The point between the middle two of four (Dubuc 1986): the cubic through them.
float between(float a, float b, float c, float d) { return 0.5625F * (b + c) - 0.0625F * (a + d); }

// Points between all points; those that were there stay.
std::vector<float> doubled(const std::vector<float>& field, std::size_t size) {
  const std::size_t twice = 2 * size;
  std::vector<float> result(twice * twice);
  parallel_for_chunks(size, rows_at_once, [&](std::size_t begin, std::size_t end) {
    std::vector<float> mixed(size);
    const auto put_row = [&](const float* row, float* to) {
      for (std::size_t x = 0; x < size; ++x) {
        to[2 * x] = row[x];
        to[2 * x + 1] = between(row[(x + size - 1) % size], row[x], row[(x + 1) % size], row[(x + 2) % size]);
      }
    };
    for (std::size_t row = begin; row < end; ++row) {
      const float* a = &field[(row + size - 1) % size * size];
      const float* b = &field[row * size];
      const float* c = &field[(row + 1) % size * size];
      const float* d = &field[(row + 2) % size * size];
      for (std::size_t x = 0; x < size; ++x) mixed[x] = between(a[x], b[x], c[x], d[x]);
      put_row(b, &result[2 * row * twice]);
      put_row(mixed.data(), &result[(2 * row + 1) * twice]);
    }
  });
  return result;
}

}  // namespace

PeriodicField::PeriodicField(const HeightField& heights, double sampled_mm)
    : heights_(heights.heights_mm.begin(), heights.heights_mm.end()) {
  ENSURE(heights.width == heights.height && std::has_single_bit(heights.width) && heights.width >= least_size);
  ENSURE(sampled_mm > 0.0);
  std::size_t size = heights.width;
  double spacing_mm = heights.spacing_mm;
  for (; size > least_size && spacing_mm * most_steps < sampled_mm; size /= 2, spacing_mm *= 2.0)
    heights_ = halved(heights_, size);
  for (; size < largest_size && spacing_mm > most_steps * sampled_mm; size *= 2, spacing_mm /= 2.0)
    heights_ = doubled(heights_, size);
  bits_ = static_cast<std::uint32_t>(std::bit_width(size) - 1);
  shift_ = 32U - bits_;
  mask_ = size - 1;
}

}  // namespace shatterpave::relief
