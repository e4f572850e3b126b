// Ring cracks of real panes: pieces from one radial to the next (glass::Rings).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/random.h"
#include "glass/map/crack_map.h"
#include "glass/pane.h"

namespace shatterpave::glass {

struct RingCentre {
  int impact = 0;
  Id id;  // of the impact
  vec2 at_mm{0.0, 0.0};
};

// Adds the pieces to the map, each as two arms of a starting point between two radials, which grow until they meet what is in
// their way. Each starts when both radials have gone by, at the speed of ring cracks. Returns the arms, two after two.
//   radials  cracks of the map that have come to their end: all that pieces may reach from one to another
std::vector<int> lay_ring_pieces(const Pane& pane, const RingCentre& centre, std::span<const int> radials, std::uint64_t seed,
                                 CrackMap& map);

}  // namespace shatterpave::glass
