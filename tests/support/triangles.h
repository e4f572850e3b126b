// Whether triangles in space meet, by brute force: the oracle for bodies that shall not touch. Corners lie on the lattice of 1
// µm and triangles are not longer than 100 mm; then it is exact.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/vec.h"

namespace shatterpave::support {

struct Triangle {
  std::array<vec3, 3> corners;
  std::size_t body = 0;  // whose it is
};

// Whether a side of one passes through the other. Triangles that share a corner, or lie in one plane, do not count.
bool meet(const Triangle& a, const Triangle& b);

// Calls visit(a, b) for each pair that meets.
void visit_meeting(const std::vector<Triangle>& triangles, const std::function<void(const Triangle&, const Triangle&)>& visit);

// The number of pairs that meet, of all pairs. Those whose boxes are apart are not looked at, which changes nothing.
std::size_t meeting_pairs(const std::vector<Triangle>& triangles);

// The number of pairs whose boxes have a point in common, as meeting_pairs finds them and by a look at every pair.
struct BoxPairs {
  std::size_t found = 0;
  std::size_t all = 0;
};
BoxPairs box_pairs(const std::vector<Triangle>& triangles);

}  // namespace shatterpave::support
