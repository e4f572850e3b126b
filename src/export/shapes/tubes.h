// Cracks as thin tubes of air within a slab of glass, no two of which touch.
//
// POV-Ray renders overlapping primitives that share an interior wrongly, and crashes on deep nests of overlapping ones. So
// the tubes are trimmed by construction: radial cracks start on the ring of a crushed zone, tubes end before the crack or the
// edge that they end on, and wherever two tubes would come too near, one is cut back. Any ray is then within at most one tube.
#pragma once

#include <cstddef>
#include <vector>

#include "core/vec.h"
#include "export/model.h"
#include "geometry/polygon.h"
#include "glass/gaps/crack_surface.h"
#include "glass/map/crack_paths.h"
#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::exporting::shapes {

// What is left free between two tubes, and between a tube and the border of the slab: ten times the lattice's step, so that
// rounding of the ends cannot close it, and far below a pixel.
inline constexpr double tube_clearance_mm = 0.01;

// A cylinder with flat ends, its axis in the middle plane of its sheet of glass.
struct Tube {
  vec2 a_mm{0.0, 0.0};  // on the lattice
  vec2 b_mm{0.0, 0.0};
  double radius_mm = 0.0;
  int crack = 0;      // id
  double z_mm = 0.0;  // of the axis
};

struct TubedCracks {
  std::vector<glass::ImpactZone> zones;  // one for each impact
  std::vector<Tube> tubes;               // those of one crack in succession
};

// The tubes of a network, and of the far sheet of laminated glass, whose cracks are `far`; as thick as the sheets ask for.
// Guarantees for each sheet, in mm, with c = tube_clearance_mm less 2 lattice steps:
//   1. the axes of two tubes are farther apart than the sum of their radii + c; or they are neighbours on one crack and lie
//      on two sides of the plane that bisects their angle;
//   2. a tube is farther than its radius + c from the outline, and its axis lies within;
//   3. zones overlap neither one another nor a tube, and lie within the outline.
// REQUIRES: pane.thickness_mm > 0; the networks are those of the pane.
TubedCracks tubed_cracks(const glass::Pane& pane, const glass::CrackNetwork& network, const glass::CrackNetwork& far = {});

// The tubes that lie within bodies of glass of the pane, in place of its outline: where a body is on both sides of a crack.
// Guarantees as above, for 2. with the borders of the bodies, and each tube within one of them. Zones are left free, but not
// filled.
//   bodies  regions that do not overlap
std::vector<Tube> tubes_within(const glass::Pane& pane, const glass::CrackNetwork& network,
                               const std::vector<geometry::Region>& bodies);

// The tubes of the cracks within joined shards; none where no shards are joined.
std::vector<Tube> joined_tubes(const BrokenPane& broken);

// The zones in which the glass about an impact is ground up: those of gaps that no hole has taken.
std::vector<glass::ImpactZone> crushed_zones(const glass::CrackSurfaces& surfaces);

}  // namespace shatterpave::exporting::shapes
