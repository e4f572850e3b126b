// Panes as odd as a scene may make them.
#pragma once

#include <cstdint>

#include "glass/pane.h"

namespace shatterpave::glass {

// How large the random numbers of a random pane may get.
struct Oddness {
  int most_impacts = 3;
  int most_radials = 40;
};

// A pure function of its arguments: an outline (thin, concave, with near-parallel and collinear edges, of 1 mm to 10 m, up to
// 1 km from the origin), impacts (anywhere, in corners, at the edge, on cracks of earlier impacts or some µm beside) and growth
// (within what a scene admits, but no steps so short that a test takes long).
Pane random_pane(std::uint64_t seed, const Oddness& oddness);

}  // namespace shatterpave::glass
