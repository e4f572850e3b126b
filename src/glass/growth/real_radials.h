// How the radials of real panes (Pattern::real) start and go along their courses.
#pragma once

#include <cstdint>
#include <vector>

#include "glass/growth/tip.h"

namespace shatterpave::glass {

// The first step of each of so many radials, mm: straight, until neighbours are apart.
double first_real_step_mm(int radial_count);

// The courses of the radials of an impact, counter-clockwise. Who dies sooner is slower, so that whom it veers to has gone by:
// the last to die are as fast as the paper's.
//   first_mm  their first step; none dies nearer to the impact
std::vector<RadialCourse> courses_of(const Pane& pane, const ImpactState& state, std::uint64_t seed, double first_mm);

// Turns a tip that has a course at its new place, and says how long its next step is: it kinks where pieces of rings will meet
// it, and veers where it dies. Steps are short near the impact, where strips are narrow, and end where the next of these is
// due.
//   step_mm  > 0, the longest step
void follow_course(Tip& tip, double step_mm);

}  // namespace shatterpave::glass
