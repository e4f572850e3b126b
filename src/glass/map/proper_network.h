// Lines from elsewhere, traced or drawn, as a crack network.
#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "glass/network.h"

namespace shatterpave::glass {

// A line that shall be a crack.
struct DrawnCrack {
  CrackKind kind = CrackKind::radial;
  int impact = 0;  // index of its impact
  bool through = true;
  std::vector<vec2> points_mm;  // two or more

  bool operator==(const DrawnCrack&) const = default;
};

// How far a line points away from the impact: the mean of cos 2φ over its length, φ being the angle between the line and the
// way from the impact. 1: all along; −1: it runs round it.
double radiality(const std::vector<vec2>& points, vec2 impact);

// `radial` where that is above 0, else `circular`.
CrackKind kind_by_direction(const std::vector<vec2>& points, vec2 impact);

// What is refused: pieces of lines, and of what they are cut into.
inline constexpr std::size_t most_drawn_pieces = 1'000'000;

// The network of the lines, as `broken` promises one (glass/breaking.h): all that lies outside the pane is cut off; where two
// lines cross, both get a vertex, and the one that comes later in the order of kinds (large and radial, branch, circular, dice,
// rung, chip) or else in the list is cut in two; of what two lines have in common, the later one loses its part. Ends that miss
// the edge, an impact or another line by no more than `snap_mm` are moved there.
//
// A crack starts at its end that lies at an impact, or else at the one nearer to its impact; circular ones start as they are
// given. Starts and ends tell what they lie on; those that lie on nothing are `origin` and `open`.
//   impacts   of the network, with points inside the outline
//   snap_mm   >= 0
// Throws InputError where more than `most_drawn_pieces` would come of the lines, or nothing.
CrackNetwork proper_network(const std::vector<DrawnCrack>& lines, const geometry::Polygon& outline_mm,
                            const std::vector<ImpactCounts>& impacts, double snap_mm);

// The counts of an impact from its cracks: N those that reach the edge, R the pieces of rings; M as it is, but no less than
// those that start there.
void count_again(CrackNetwork& network, int impact);

}  // namespace shatterpave::glass
