// What every crack network must hold, checked the slow way, from the polylines alone.
#pragma once

#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "glass/network.h"

namespace shatterpave::glass {

// What the lists of faults below are to be compared with.
inline const std::vector<std::string> nothing;

// One line for each promise of glass/network.h and glass/growth/growth.h that the network breaks; empty if it is sound:
// - cracks lie on the lattice and in the pane; one that meets the edge ends there;
// - two cracks have no stretch in common, do not cross, and meet only where one of them starts or ends;
// - each starts and ends where its record says.
//   grows  not all cracks need be there
std::vector<std::string> faults(const CrackNetwork& network, const geometry::Polygon& outline, bool grows = false);

// The same for the second stop rule (§4.2.3 (2)), of a sound network:
// - a crack that stopped `enclosed` is no ring crack, and cracks that existed then surround its tip;
// - no crack but of rings is `open` where cracks surround it, unless those of earlier impacts surrounded its start already.
std::vector<std::string> enclosure_faults(const CrackNetwork& network);

// The number of proper crossings of two pieces of cracks, of one crack with itself too.
int crossings(const CrackNetwork& network);

}  // namespace shatterpave::glass
