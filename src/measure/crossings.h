// Places where cracks cross, of which there must be none: a crack ends where it meets another (rule 8 of Agui et al. 1992,
// §3.2).
#pragma once

#include <vector>

#include "geometry/lattice.h"
#include "glass/network.h"

namespace shatterpave::measure {

struct Crossing {
  int crack = 0;  // ids, the lower first; the same twice for a crack that crosses itself
  int other = 0;

  auto operator<=>(const Crossing&) const = default;
};

// Every place, sorted, where two pieces of cracks cross properly, or where two cracks touch in a point that is an end of
// neither. Exact on the lattice. n pieces take n log n steps where they are spread over the pane.
std::vector<Crossing> crossings(const glass::CrackNetwork& network);

}  // namespace shatterpave::measure
