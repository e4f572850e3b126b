// Layers of polygons laid over one another, as one planar map: which layers cover each of its faces.
//
// Sides of different layers may cross, touch or run along each other in any way, also nearly. They are rounded to the lattice
// together (snap rounding; Hobby, "Practical segment intersection with finite precision output", 1999): each side bends to the
// lattice points next to which it passes and that are a vertex or a crossing, by less than 0.71 µm. After that sides meet in
// their ends only, and all that follows is exact: faces do not overlap and leave nothing between them, and neighbours share
// their vertices to the bit.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/planar_map.h"
#include "geometry/polygon.h"

namespace shatterpave::geometry {

// The rings of a layer, which may cross and touch in any way: the layer covers what they wind about.
using Layer = std::vector<Polygon>;

struct Overlay {
  static constexpr std::size_t outside = std::numeric_limits<std::size_t>::max();

  std::vector<Segment> sides;                          // meet in their ends only, each once
  std::vector<std::array<std::size_t, 2>> beside;      // of a side a → b: the face on its left, on its right; or outside
  std::vector<Face> faces;                             // the bounded ones
  std::vector<std::vector<std::uint32_t>> covered_by;  // of each face: the layers, ascending
};

// Takes time near-linear in the number of sides and their crossings.
Overlay overlay(std::span<const Layer> layers);

// Parts of an overlay as regions: the faces with one label make one region for each set of them that hangs together by sides.
//   label  of each face
// Regions keep the vertices of the map, except those on a straight line at which only two regions meet.
struct LabelledRegion {
  Region region;
  std::uint32_t label = 0;
};
std::vector<LabelledRegion> labelled_regions(const Overlay& map, std::span<const std::uint32_t> label);

// New labels, so that no connected set of faces with one label is thinner than `width_mm` (its area less than half its border
// times that). A thin set takes the label of the neighbour with which it shares most of its border, of those that are not
// labelled `fixed`, if there is one; sets labelled `fixed` stay.
std::vector<std::uint32_t> without_slivers(const Overlay& map, std::vector<std::uint32_t> label, double width_mm,
                                           std::uint32_t fixed);

}  // namespace shatterpave::geometry
