// Cracks of the lines of a picture.
#pragma once

#include <functional>
#include <vector>

#include "glass/map/proper_network.h"
#include "trace/line_graph.h"

namespace shatterpave::trace {

// In px of the picture; `points_mm` of each line too.
struct CrackRules {
  vec2 impact{0.0, 0.0};
  double hub_px = 6.0;         // lines begin here: within it they run together
  double merged_px = 6.0;      // lines that begin nearer than this begin at the impact, though they may touch a neighbour
  double least_ring_px = 8.0;  // shorter pieces of rings are none
  double edge_px = 6.0;        // lines that come so near to the border reach it
};

// The cracks: at each junction the two edges that go on most straight, within 40°, are one line. Along the way to the impact
// (the mean of cos 2φ over their length, φ being the angle to it, above 0) a line is radial, or a branch if it leaves another
// line that way, at 15° to 75°, beyond `merged_px`; `large` where it reaches the border. Else it is circular: a piece of a
// ring, which ends where it meets a radial.
//   features  the feature points of a line whose points lie a pixel apart (trace/two_point.h)
using FeaturePoints = std::function<std::vector<vec2>(const std::vector<vec2>&)>;
std::vector<glass::DrawnCrack> cracks_of(const LineGraph& graph, const CrackRules& rules, const FeaturePoints& features,
                                         int width, int height);

}  // namespace shatterpave::trace
