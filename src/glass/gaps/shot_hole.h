// The hole that a shot leaves: narrow on the side of the impact, and wider on the far side, where a cone of glass has spalled
// off in flakes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/random.h"
#include "core/vec.h"

namespace shatterpave::glass {

struct ShotHoleShape {
  vec2 centre_mm{0.0, 0.0};
  double thickness_mm = 2.0;
  double hole_radius_mm = 0.0;   // on the side of the impact, which is the viewer's (+z)
  double spall_radius_mm = 0.0;  // on the far side, of a round cone; flakes reach a third farther. >= hole_radius_mm

  bool operator==(const ShotHoleShape&) const = default;
};

// Air within the slab, closed: between the two faces of the pane less a skin. The wall is a grid of rings, from the impact's
// face to the far one; point k of ring i is number i * points + k. All lie on the lattice.
struct ShotHole {
  ShotHoleShape shape;
  std::size_t rings = 0;
  std::size_t points = 0;  // of a ring, counter-clockwise
  std::vector<vec3> wall_mm;
  std::vector<vec3> normals;  // unit, of the wall, away from the air

  bool operator==(const ShotHole&) const = default;
};

// How far out the wall may be at a height, flakes and all.
double widest_mm(const ShotHoleShape& shape, double z_mm);

// `element` names the impact for the draws of its flakes.
ShotHole shot_hole(const ShotHoleShape& shape, std::uint64_t seed, const Id& element);

// As triangles, counter-clockwise as seen from without. Numbers below wall_mm.size() are points of the wall; the next two are
// the middles of the impact's end and of the far end.
std::vector<std::size_t> closed_triangles(const ShotHole& shot_hole);
std::vector<vec3> middles_mm(const ShotHole& shot_hole);

}  // namespace shatterpave::glass
