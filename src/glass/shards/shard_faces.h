// The faces of a crack network: what a pane falls into.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/planar_map.h"
#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// What the segments of the map belong to.
inline constexpr int pane_edge = -1;

struct ShardFace {
  // What the face is, so that nothing else in the scene shows in it: the crack with the least id on its border, the side of
  // that crack on which it lies (from its start), and its ordinal among the faces along that side, from 0: "c12l3" is the
  // fourth one on the left of crack 12. "whole" where no crack borders it.
  std::string id;
  geometry::Face face;  // of the segments of FacedPane
};

struct FacedPane {
  std::vector<geometry::Segment> segments;      // the edge, then the cracks; owner: id of the crack, or pane_edge
  std::vector<geometry::LatticePoint> outward;  // for each segment of the edge, as geometry::faces wants it
  std::vector<ShardFace> faces;
};

// Guarantee: faces tile the pane exactly but for this: where a crack ends at an edge that is neither upright nor level, its end
// lies within 1 µm of it and inside (crack_map.h), and faces reach to that point only; where cracks run along such an edge as
// near to it, faces may overlap by as much. Cracks that end inside a face are its spurs.
//   REQUIRES the network is that of the pane
FacedPane faced_pane(const Pane& pane, const CrackNetwork& network);

// The border of a face as a region.
geometry::Region region(const geometry::Face& face);

}  // namespace shatterpave::glass
