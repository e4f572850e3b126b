// Cracks as the paper measured them on photographs (Agui et al. 1992, §3.1.2): two-point tracking makes of a line a polyline of
// chords of one length, and turns are taken between chords.
#pragma once

#include <span>
#include <vector>

#include "core/angle.h"
#include "core/vec.h"
#include "glass/pane.h"

namespace shatterpave::measure {

// a of §3.1.2, by which a pair of tracking points moves.
inline constexpr double chord_mm = 10.0 * glass::px_mm;

// The feature points of a line: its first point, then each the first one along the line that is `step_mm` away from the one
// before as the crow flies. What is left at the end, shorter than a step, has no point.
//   line     one point or more, mm
//   step_mm  > 0
std::vector<vec2> tracked(std::span<const vec2> line, double step_mm = chord_mm);

// The same points as the paper had them from photographs, each at the middle of a pixel: moved to the nearest place that is
// whole pixels away from `origin`, half a pixel at the most each way.
std::vector<vec2> at_whole_pixels(std::vector<vec2> feature_points, vec2 origin);

// Where the segment from `from`, which lies within the circle of `radius` about `centre`, to `to`, which does not, leaves it.
vec2 way_out(vec2 centre, double radius, vec2 from, vec2 to);

// The turns θ_i between each chord S_i and the next, S_i+1 (Fig. 3), counter-clockwise positive, within ±180°: two fewer than
// there are points.
std::vector<Angle> turns(std::span<const vec2> feature_points);

}  // namespace shatterpave::measure
