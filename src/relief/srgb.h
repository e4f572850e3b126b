// The curve of sRGB (IEC 61966-2-1), for many values.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace shatterpave::relief {

// Over 0 … 1, as a table with straight lines between: off by less than a tenth of a step of 8 bits.
class SrgbCurve {
 public:
  SrgbCurve();

  float operator()(float linear) const {
    const float at = std::clamp(linear, 0.0F, 1.0F) * static_cast<float>(steps);
    const auto k = static_cast<std::size_t>(at);
    return table_[k] + (at - static_cast<float>(k)) * (table_[k + 1] - table_[k]);
  }

 private:
  static constexpr std::size_t steps = 4096;
  std::array<float, steps + 2> table_{};
};

}  // namespace shatterpave::relief
