// A smooth way from 0 to 1.
#pragma once

#include <algorithm>

namespace shatterpave {

// 0 up to x = 0, 1 from x = 1 on, between them 3 x² − 2 x³, which is level at both ends.
inline double smooth_step(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace shatterpave
