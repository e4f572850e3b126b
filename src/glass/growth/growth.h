// Growth of cracks in a pane: the probability model of Agui et al. 1992 (§3.2, §4).
#pragma once

#include <cstdint>

#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// Throws InputError for a step with which cracks would need more than a million to cross the pane.
void require_few_steps(const Pane& pane);

// The cracks of `pane` as annealed glass. Impacts happen in their order; cracks of a later one stop at those of an earlier one.
// A pure function of its arguments: draws are addressed by the pane's name, the impact's index and the crack's place.
//
// Guarantees, exact on the lattice: all vertices lie in the pane; no two cracks cross; a crack that ends on another ends in a
// vertex of its polyline; a crack that ends at the edge ends within 1 µm of it.
//
// Two cases in which fewer cracks come to be than were drawn: a ring crack's starting point that lies outside the pane or
// behind an edge or an earlier crack, seen from its impact, is left out; and so is a crack that stops before it is 1 µm long,
// or 2 µm away from its neighbours.
//
// REQUIRES the ranges of glass/pane.h, impacts strictly inside the outline, and what `require_few_steps` asks.
//
// A tip costs the same per step whatever grows elsewhere. See benchmarks/growth.cpp for the figures.
CrackNetwork grown_cracks(const Pane& pane, std::uint64_t seed);

}  // namespace shatterpave::glass
