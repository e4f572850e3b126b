// A periodic height field made ready to be asked at many places, at about one distance from each other.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "relief/height_field.h"

namespace shatterpave::relief {

// Places are phases: 2^32 stands for a period, so that they wrap round by themselves and no place is less exact than another.
class PeriodicField {
 public:
  // The square field of `heights`, whose side is a power of two, for places `sampled_mm` apart (> 0). Waves too short for that
  // distance are filtered out, and where the points are farther apart than it, a smooth surface is laid through them.
  PeriodicField(const HeightField& heights, double sampled_mm);

  static std::uint32_t phase(double periods) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>((periods - std::floor(periods)) * 4294967296.0));
  }
  // Of a step, which may be negative and is less than half a period.
  static std::uint32_t phase_step(double periods) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(periods * 4294967296.0));
  }

  // mm. Row by row downwards, v is that of the rows.
  float at(std::uint32_t u, std::uint32_t v) const {
    const std::size_t column = u >> shift_;
    const std::size_t row = v >> shift_;
    const float right = fraction(u);
    const float down = fraction(v);
    const float* upper = &heights_[row << bits_];
    const float* lower = &heights_[((row + 1) & mask_) << bits_];
    const std::size_t next = (column + 1) & mask_;
    const float above = upper[column] + right * (upper[next] - upper[column]);
    const float below = lower[column] + right * (lower[next] - lower[column]);
    return above + down * (below - above);
  }

  // Points along a side.
  std::size_t size() const { return mask_ + 1; }

 private:
  float fraction(std::uint32_t phase) const { return static_cast<float>((phase << bits_) >> 8U) * (1.0F / 16777216.0F); }

  std::vector<float> heights_;
  std::uint32_t bits_ = 0;   // of the size
  std::uint32_t shift_ = 0;  // 32 − bits
  std::size_t mask_ = 0;
};

}  // namespace shatterpave::relief
