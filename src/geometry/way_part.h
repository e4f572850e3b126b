// Parts of a straight way, as shares of it.
#pragma once

#include <algorithm>

namespace shatterpave::geometry {

// Narrows [first, last] to where value_a + t (value_b − value_a) >= 0; an empty range has first > last.
inline void keep_non_negative(double value_a, double value_b, double& first, double& last) {
  if (value_a < 0.0 && value_b < 0.0) {
    first = 1.0;
    last = 0.0;
  } else if (value_a < 0.0) {
    first = std::max(first, value_a / (value_a - value_b));
  } else if (value_b < 0.0) {
    last = std::min(last, value_a / (value_a - value_b));
  }
}

}  // namespace shatterpave::geometry
