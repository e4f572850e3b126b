// The hole that is left where something goes through a pane whose pieces come loose.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/polygon.h"
#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// Half the width of the hole of an impact, mm: half of `hole_mm` where that is given, else so much that a disc of it holds the
// glass that leaves by `missing` and `missing_mm` of the pane's shards, missing_mm √(missing √π / 2). 0: no hole.
//   REQUIRES pane.shards
double hole_radius_mm(const Pane& pane, const Impact& impact);

// missing_mm where the scene does not say: in proportion to the root of the pane's area, and to the fourth root of the energy
// of the steel ball that hits.
double usual_missing_mm(const Pane& pane, const Impact& impact);

// All that leaves the pane; it may reach beyond its outline, and is empty where nothing leaves. About each impact the border is
// 6 to 12 smooth arcs that bulge into the glass that stays and meet in cusps of 20 to 60°, which point inwards, by 5 to 20 % of
// the hole's width: daggers. Each points out of a strip between two cracks. Where the hole reaches the edge, teeth are left
// along it, in the rebate of the frame.
//   REQUIRES pane.shards; the network is that of the pane
std::vector<geometry::Region> hole_outlines(const Pane& pane, const CrackNetwork& network, std::uint64_t seed);

}  // namespace shatterpave::glass
