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

// The faces of a pane while its cracks grow.
struct GrownFaces {
  FacedPane pane;              // a face that is whole has the id that it will keep; any other that of the first it falls into
  std::vector<bool> is_whole;  // of each face: no crack will divide it
  std::vector<std::size_t> becomes;  // of each face: the number of the face at the end that it is, or the first in it
};

// Those of the network at a time, `now`, whose faces at the end are `end`. Each is one of these, or several between which a
// crack is not yet.
//   REQUIRES `end` is that of `network`, and `now` follows from it (map/growth_clock.h)
GrownFaces grown_faces(const FacedPane& end, const CrackNetwork& network, const CrackNetwork& now);

// The border of a face as a region.
geometry::Region region(const geometry::Face& face);

}  // namespace shatterpave::glass
