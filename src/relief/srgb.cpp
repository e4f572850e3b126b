#include "relief/srgb.h"

#include "core/functions.h"

namespace shatterpave::relief {

SrgbCurve::SrgbCurve() {
  for (std::size_t k = 0; k <= steps; ++k) {
    const double linear = static_cast<double>(k) / steps;
    table_[k] = static_cast<float>(linear <= 0.0031308 ? 12.92 * linear : 1.055 * power(linear, 1.0 / 2.4) - 0.055);
  }
  table_[steps + 1] = table_[steps];
}

}  // namespace shatterpave::relief
