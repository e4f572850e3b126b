// How a tip turns: the forces of Agui et al. 1992, §4.2.2.
#pragma once

#include <optional>
#include <span>

#include "core/angle.h"
#include "core/vec.h"
#include "geometry/segment_index.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// A crack or an edge in the sector.
struct Wall {
  vec2 towards{0.0, 0.0};    // perpendicular to it, of unit length
  double distance_mm = 0.0;  // of its nearest point in the sector, >= 0
};

// That of the segment whose point nearest to a tip at `from` is `nearest_mm`.
Wall wall_at(vec2 nearest_mm, const geometry::Segment& segment, vec2 from);

// What a tip sees in its sector.
struct Sight {
  std::span<const vec2> tips_mm;  // other growing tips, from this one; none at distance 0
  std::optional<Wall> crack;      // the nearest
  std::optional<Wall> sibling;    // the nearest radial of the same impact, for a radial
  std::optional<Wall> edge;
};

// The circle that a ring crack follows.
struct Ring {
  vec2 centre_mm{0.0, 0.0};
  double radius_mm = 0.0;
  bool counter_clockwise = true;
};

// F2 of one crack, or of the edge; F1 of one tip, at `offset_mm` from this one, not 0. Each falls with the square of the
// distance; in units of the magnitude of F3, with gains in px².
vec2 pull_of(const Wall& wall, double gain);
vec2 push_of(vec2 offset_mm, double gain);

// F1 + F2: away from tips, and perpendicularly towards cracks and the edge, each falling with the square of the distance; in
// units of the magnitude of F3.
vec2 force_of(const Sight& sight, const Growth& growth);

// Where a ring crack at `at_mm` has to go to follow its circle: along it, and back to it where it has left it (rule 5).
vec2 direction_along(const Ring& ring, vec2 at_mm);

// 1 − weight of eq. 19, of a crack that started `age` ago. That of a longer age is the product of those of its parts.
double inertia(double age, const Growth& growth);

// The angle by which a tip of that weight turns towards the force (eq. 12 to 15, 18).
Angle turn_towards(vec2 force, vec2 heading, double weight, const Growth& growth);

// The angle by which a tip of that weight turns in a step of `step_px` (eq. 12 to 15, 18), for its share of turn_length.
Angle turn(vec2 force, vec2 heading, double weight, double step_px, const Growth& growth);

// `v` turned counter-clockwise by `angle`. Not `rotated` of core/angle.h: sine and cosine found together differ from those
// found one by one in the last bits, and so would every crack.
vec2 turned(vec2 v, Angle angle);

// F3 of such a step, of magnitude 1: about the heading, its direction off by `deviate`, a standard normal number, times what
// makes the turns over turn_length have the standard deviation `wander`.
vec2 wandering_force(vec2 heading, double deviate, double step_px, const Growth& growth);

// The heading of a ring crack after `way_mm` along its circle.
vec2 bent_along(const Ring& ring, vec2 heading, double way_mm);

}  // namespace shatterpave::glass
