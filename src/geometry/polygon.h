// Polygons and regions.
#pragma once

#include <vector>

#include "core/vec.h"

namespace shatterpave::geometry {

// A simple polygon: its vertices in order, the first not repeated at the end.
using Polygon = std::vector<vec2>;

// A polygon with holes. `outline` runs counter-clockwise, `holes` clockwise; holes lie inside and do not overlap; they may
// touch the outline or one another in single points. All vertices lie on the lattice.
struct Region {
  Polygon outline;
  std::vector<Polygon> holes;

  bool operator==(const Region&) const = default;
};

struct Box {
  vec2 low{0.0, 0.0};
  vec2 high{0.0, 0.0};
};

// Whether the boxes have a point in common; points of their borders count.
inline bool boxes_meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

// Signed: positive for counter-clockwise; mm².
double area(const Polygon& polygon);
double area(const Region& region);

// Of all its rings; mm.
double perimeter(const Polygon& polygon);
double perimeter(const Region& region);

vec2 centroid(const Polygon& polygon);

// The smallest box about the polygon, which must not be empty.
Box bounding_box(const Polygon& polygon);

// Whether `point` lies inside or on the border, exact on the lattice.
bool contains(const Polygon& polygon, vec2 point);
// Inside and not on the border; exact on the lattice.
bool contains_strictly(const Polygon& polygon, vec2 point);
// Inside the outline or on a border, and not inside a hole.
bool contains(const Region& region, vec2 point);

}  // namespace shatterpave::geometry
