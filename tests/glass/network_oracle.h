// What every crack network must hold, checked the slow way: all pairs, no index.
#pragma once

#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "glass/network.h"

namespace shatterpave::glass {

// One line for each promise of glass/network.h and glass/growth.h that the network breaks; empty if it is sound.
std::vector<std::string> faults(const CrackNetwork& network, const geometry::Polygon& outline);

// The number of proper crossings of two pieces of cracks, of one crack with itself too.
int crossings(const CrackNetwork& network);

}  // namespace shatterpave::glass
