// Whether rings make a region: an exact test on the lattice, in O(n log n), which says what is wrong and where.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::geometry {

// Edge `edge` of ring `ring` runs from its vertex `edge` to the next one, cyclically. Ring 0 is the outline, ring k the hole
// k − 1.
struct RingEdge {
  std::size_t ring = 0;
  std::size_t edge = 0;

  bool operator==(const RingEdge&) const = default;
};

struct RegionFault {
  enum class Kind {
    crossing,      // edges a and b cross in one point
    overlap,       // edges a and b have a stretch in common
    touch,         // a ring meets itself in the point: edges a and b of one ring
    hole_outside,  // edge a of a hole has the hole's inside where the outline has its outside
    holes_overlap  // edge a of a hole lies inside another hole
  };
  Kind kind = Kind::crossing;
  RingEdge a;
  RingEdge b;  // as a, where the kind names one edge only
  vec2 at_mm{0.0, 0.0};

  bool operator==(const RegionFault&) const = default;
};

// What keeps `outline` and `holes` from being a region, or nothing. Rings may turn either way.
//   REQUIRES  each ring has 3 or more vertices, on the lattice, each different from the next one, cyclically
// Rings of a region are simple and do not cross; holes lie inside the outline and outside each other; two rings may touch in
// single points.
std::optional<RegionFault> region_fault(const Polygon& outline, const std::vector<Polygon>& holes);

// The same rings with the outline counter-clockwise and the holes clockwise; first vertices stay first.
Region oriented_region(Polygon outline, std::vector<Polygon> holes);

}  // namespace shatterpave::geometry
