// Two-point tracking of line figures (Agui et al. 1992, §3.1.2).
#pragma once

#include <vector>

#include "trace/picture.h"

namespace shatterpave::trace {

// The feature points of a line: a pair of points, L and R, on the two sides of the figure is moved along it by `step_px` at a
// time; the points are the middles C of the pairs. Across, L and R are sought up to `reach_px` from the middle line; where the
// figure is wider, as at junctions, the middle line's own point stands. The first and the last point of the middle line stay.
//   middle_line  of the figure, two points or more, no two of them more than a few px apart, px
std::vector<vec2> feature_points(const Mask& figures, const std::vector<vec2>& middle_line, double step_px, double reach_px);

}  // namespace shatterpave::trace
