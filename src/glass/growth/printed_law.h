// Growth by the letter of Agui et al. 1992, §4.2: eq. 12 to 19 as printed, beside which ours (growth.cpp) can be seen.
//
// All tips go on at once, by steps of dt (time_step): every tip looks at what is there at the time t, turns, and goes on by
// v dt, until all large and ring cracks have stopped. All growing tips in the local region count in F1; in F2 all cracks in it
// but the tip's own, radials of its impact among them, and the edge, each by its nearest point. So the whole of v turns once a
// step, by up to turn_limit, whatever way it goes in it. Ring cracks start with the radials, and the second stop rule holds for
// them, too.
//
// What the paper leaves open, and what stands for it here:
// - F3 has the magnitude 1, and the angle between it and v the standard deviation `wander`, drawn anew in every step. The gains
//   of F1 and F2 are those of ours: with them the two laws differ in nothing but what is told above.
// - Rule 5, that rings follow their circle, has no formula. A ring crack bends with its circle and is pulled back to it
//   (ring_pull), as in ours; without that it would leave by the tangent.
// - Of two tips whose ways cross within one step, that of the lower number was there first: radials before rings.
// - Sizes of the rectangle and of the circle are not told. The rectangle lies ahead of the tip, the circle about it, and both
//   reach as far as the sector by default.
// - A radial has no vertex while its neighbours are within 0.05 mm, for the lattice's sake, as in ours; it goes straight then.
#pragma once

#include <cstdint>
#include <vector>

#include "glass/map/crack_map.h"
#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// The shortest step that a tip may make, px.
double least_printed_step_px(const Growth& growth);

// Grows the cracks of all impacts into `map`, and returns their counts. The same guarantees as of grown_cracks.
//
// A step of a tip costs what lies in its region, however large the pane is: about an impact that goes with its number of
// radials, and where cracks wind about with the length of their windings. A pane of M = 105 takes a quarter longer than by the
// fitted law, with the circle four times as long; 10,000 radials of one impact take as long as by it.
std::vector<ImpactCounts> grow_by_printed_law(const Pane& pane, std::uint64_t seed, CrackMap& map);

}  // namespace shatterpave::glass
