#include "geometry/polygon.h"

#include <algorithm>

#include "core/error.h"
#include "geometry/predicates.h"

namespace shatterpave::geometry {

namespace {

enum class Location { outside, border, inside };

// Counts the crossings of a ray from `p` towards +x, with the half-open rule for vertices.
Location location(const Polygon& polygon, LatticePoint p) {
  bool inside = false;
  LatticePoint previous = to_lattice(polygon.back());
  for (const vec2& vertex : polygon) {
    const LatticePoint current = to_lattice(vertex);
    if (on_segment(previous, current, p)) return Location::border;
    if ((previous.y > p.y) != (current.y > p.y)) {
      const Side s = side(previous, current, p);
      if ((current.y > previous.y) == (s == Side::left)) inside = !inside;
    }
    previous = current;
  }
  return inside ? Location::inside : Location::outside;
}

}  // namespace

double area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    // About the first vertex, so that places far from the origin lose no digits.
    twice += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  }
  return 0.5 * twice;
}

double area(const Region& region) {
  double total = std::abs(area(region.outline));
  for (const Polygon& hole : region.holes) total -= std::abs(area(hole));
  return total;
}

double perimeter(const Polygon& polygon) {
  double total = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) total += glm::length(polygon[(i + 1) % polygon.size()] - polygon[i]);
  return total;
}

double perimeter(const Region& region) {
  double total = perimeter(region.outline);
  for (const Polygon& hole : region.holes) total += perimeter(hole);
  return total;
}

vec2 centroid(const Polygon& polygon) {
  vec2 moment{0.0, 0.0};
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const vec2 a = polygon[i] - polygon[0];
    const vec2 b = polygon[(i + 1) % polygon.size()] - polygon[0];
    const double weight = cross(a, b);
    moment += weight * (a + b);
    twice += weight;
  }
  return twice == 0.0 ? polygon[0] : polygon[0] + moment / (3.0 * twice);
}

Box bounding_box(const Polygon& polygon) {
  ENSURE(!polygon.empty());
  Box box{polygon.front(), polygon.front()};
  for (const vec2& vertex : polygon) {
    box.low = {std::min(box.low.x, vertex.x), std::min(box.low.y, vertex.y)};
    box.high = {std::max(box.high.x, vertex.x), std::max(box.high.y, vertex.y)};
  }
  return box;
}

bool contains(const Polygon& polygon, vec2 point) { return location(polygon, to_lattice(point)) != Location::outside; }

bool contains_strictly(const Polygon& polygon, vec2 point) { return location(polygon, to_lattice(point)) == Location::inside; }

bool contains(const Region& region, vec2 point) {
  const LatticePoint p = to_lattice(point);
  if (location(region.outline, p) == Location::outside) return false;
  return std::ranges::none_of(region.holes, [p](const Polygon& hole) { return location(hole, p) == Location::inside; });
}

}  // namespace shatterpave::geometry
