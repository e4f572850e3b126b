// From the drawing of one repeat of a pattern to the stones of a bond (`Module`).
//
// Shapes of a drawing mean one of two things, and which it is shows in the drawing:
//   - shapes that touch are stones with half a joint about them. Half of `joint_mm` is taken off all round;
//   - where a gap of one width is left between all of them, the gap is the joint as it was drawn and the shapes are the stones
//     themselves. They grow by half of the gap until they touch. A joint may be wider than it was drawn, never narrower: so
//     that stones are never larger than they were drawn.
// Either way stones and joints together cover the plane: whatever else stays bare is refused.
//
// Drawings are as exact as a hand with a grid is. Corners within `module_tolerance_mm` of one another, or of a side, are one,
// or lie on it; what stones still overlap within that width, the later one loses.
#pragma once

#include <cstddef>
#include <vector>

#include "core/error.h"
#include "geometry/polygon.h"
#include "paving/pavement.h"

namespace shatterpave::paving {

// Two lines through one drawn curve are up to 0.1 mm off each, on either side of it (svg_tolerance_mm).
inline constexpr double module_tolerance_mm = 0.2;
// All pairs of stones and all pairs of corners are looked at: some seconds at these limits. Patterns of the trade have two to
// thirty stones.
inline constexpr std::size_t most_module_stones = 1000;
inline constexpr std::size_t most_module_corners = 3000;
// Of a stone, along either vector: how many repeats it may reach over.
inline constexpr double longest_module_stone = 50.0;

struct DrawnStone {
  geometry::Region shape_mm;  // on the lattice
  Place place;                // in the drawing, for messages
};

struct DrawnModule {
  std::vector<DrawnStone> stones;  // one or more
  vec2 first_mm{0.0, 0.0};         // the two vectors by which they repeat
  vec2 second_mm{0.0, 0.0};
  Place place_of_stones;   // of the drawing's name in the scene
  Place place_of_vectors;  // in the scene
};

// Gives the pavement the stones of the drawing: `Bonding::module_drawn`, and `stone_mm`, length and width of the smallest.
//   REQUIRES  `pavement.joint_mm` as it will be laid
// Throws InputError where
//   - there are too many stones or corners, or a shape has a hole;
//   - the vectors are parallel or shorter than the least stone;
//   - shapes overlap one another or their own repeats by more than the tolerance;
//   - more stays bare than joints: gaps wider than `joint_mm` or of several widths, or a spot, as rounded corners leave, that
//     is wider than a tenth of the smallest stone's length (`widest_bare`);
//   - a stone is narrower than `stone_bounds_mm.low` without its half joints, or falls apart.
void lay_as_drawn(Pavement& pavement, const DrawnModule& drawn);

}  // namespace shatterpave::paving
