// What is measured on a pane of tempered glass, as EN 12150-1 tests it.
#pragma once

#include <vector>

#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::measure {

// The side of the squares in which fragments are counted, and what is left out about the impact and along the edge.
inline constexpr double counting_square_mm = 50.0;
inline constexpr double left_out_at_impact_mm = 80.0;
inline constexpr double left_out_at_edge_mm = 25.0;

// The number of fragments in each square of a grid that the rule lets be counted; a fragment that the border of the square cuts
// counts half. No square where the pane is too small.
//
// In a square, whole fragments and half of those that its border cuts are 1 + (j − f) / 2, where j is the number of ends of
// cracks that lie on other cracks, and f that of ends that lie free: Euler's formula, where fragments are joined to the border
// once.
std::vector<double> fragment_counts(const glass::CrackNetwork& network, const glass::Pane& pane);

// How much cracks between two distances from the first impact point away from it: the mean of cos 2φ over their length, φ being
// the angle between the crack and the direction from the impact. 1: all do; 0: no direction; −1: all run round it.
double radiality(const glass::CrackNetwork& network, double from_mm, double to_mm);

}  // namespace shatterpave::measure
