// Stones as a hand lays them in the places that were set out: each corner lies by itself.
#pragma once

#include <cstdint>

#include "core/random.h"
#include "paving/pavement.h"

namespace shatterpave::paving {

// A face whose corners have moved, so that the joints about it are wedges: of many their median is `joint_mm`, the standard
// deviation of ln(width) up to 0.6. Then corners are rounded and nibbled as `HandLaying` says.
//   outline  simple, counter-clockwise, on the lattice
//   room_mm  how far from `outline` a point may lie outside it, >= 0
// Of a convex outline corners may move inwards farther than that. Every point of the result lies in the outline or within
// `room_mm` of it, but for rounding to the lattice. Simple, counter-clockwise, on the lattice; a pure function of its
// arguments.
geometry::Polygon hand_face(const geometry::Polygon& outline, const Pavement& pavement, double room_mm, std::uint64_t seed,
                            Id stone);

// How deep a stone has sunk by itself, mm; 0 for most.
double sunk_mm(const Pavement& pavement, std::uint64_t seed, Id stone);

}  // namespace shatterpave::paving
