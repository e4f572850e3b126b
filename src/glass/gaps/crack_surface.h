// Cracks as what they are: thin gaps of air between two walls that run through the thickness of the pane, lean, twist and bow
// as they go along, and never touch one another.
//
// Renderers take overlapping bodies that share an interior wrongly, and crash on deep nests of overlapping ones. So each crack
// gets a corridor in the plane about its polyline, half as wide as what is free between it and the nearest other crack, and its
// walls stay within their corridor at any depth. Corridors of two cracks do not meet, except near a joint, where the crack that
// ends is cut off, depth by depth, before the wall of the one it ends on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.h"
#include "glass/gaps/shot_hole.h"
#include "glass/map/crack_paths.h"
#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// A piece of a gap: two walls as grids of points, column by column along the crack, in each column `rows` points from the face
// of the pane where the crack opens to its depth. Point r of column c is number c * rows + r. z is 0 in the middle of the
// pane and rises towards the viewer.
struct CrackSurface {
  int crack = 0;   // id
  int impact = 0;  // index of the impact that the crack belongs to
  std::size_t rows = 0;
  std::vector<vec3> left_mm;   // wall on the left of the way from column to column
  std::vector<vec3> right_mm;  // as many
  std::vector<vec3> normals;   // unit, of the middle between the walls, to the left; as many

  std::size_t columns() const { return left_mm.size() / rows; }
  bool operator==(const CrackSurface&) const = default;
};

struct CrackSurfaces {
  std::vector<ImpactZone> zones;       // one for each impact
  std::vector<ShotHole> shot_holes;    // of the impacts that went through, each within its zone
  std::vector<CrackSurface> surfaces;  // those of one crack in succession

  bool operator==(const CrackSurfaces&) const = default;
};

// The gaps of all cracks of a broken pane, shaped by pane.crack_sheet; of laminated glass those of the sheet that is hit,
// through that sheet. Guarantees:
//   1. the walls of two gaps do not meet, nor do the two walls of a gap, nor a wall and itself (gap_meetings.h looks at the
//   end);
//   2. gaps do not meet holes: those that start at the impact end before its wall, the others outside the zone;
//   3. all gaps lie within the outline, at least crack_skin_mm below the faces of the sheet, and, but for those
//      gaps, outside the zones;
//   4. the same pane, network and seed give the same bits at any number of threads;
//   5. where the pane has a time, gaps are those of all cracks as far as these have grown, with the zones and holes of the
//      impacts that have come: what is there stays as it is, but for some thicknesses behind a tip.
// A stretch along which other cracks are too near to leave room for a gap is left out, and so are chips.
// REQUIRES: the network is that of the pane.
CrackSurfaces crack_surfaces(const Pane& pane, const CrackNetwork& network, std::uint64_t seed);

// The same of the far sheet of laminated glass, whose cracks are `far` (glass/breaking.h), clear of the zones and holes about
// the impacts that `crack_surfaces` makes of `near`.
std::vector<CrackSurface> far_surfaces(const Pane& pane, const CrackNetwork& near, const CrackNetwork& far, std::uint64_t seed);

// The same gap as a closed surface of triangles, three numbers of points each, counter-clockwise as seen from without. Numbers
// below left_mm.size() are points of the left wall, those from there on of the right one.
std::vector<std::size_t> closed_triangles(const CrackSurface& surface);

}  // namespace shatterpave::glass
