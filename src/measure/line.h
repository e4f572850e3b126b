// Least-squares lines.
#pragma once

#include <cstddef>
#include <span>

#include "core/vec.h"

namespace shatterpave::measure {

// y = slope x + intercept, fitted to points by least squares.
struct Line {
  std::size_t count = 0;         // points
  double slope = 0.0;            // 0 where all points have one x
  double intercept = 0.0;        // the mean of y where all points have one x
  double residual = 0.0;         // standard deviation about the line, by count − 2; 0 for fewer than 3 points
  double correlation = 0.0;      // r; 0 where x or y does not vary
  double slope_error = 0.0;      // standard errors of slope and intercept; infinite where fewer than 3 points or one x only
  double intercept_error = 0.0;  // cannot tell them
  double low_x = 0.0;            // least and greatest x of the points
  double high_x = 0.0;

  double at(double x) const { return slope * x + intercept; }

  bool operator==(const Line&) const = default;
};

// The line of no point at all is all zeros, with infinite errors.
Line fitted_line(std::span<const vec2> points);

}  // namespace shatterpave::measure
