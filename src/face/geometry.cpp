#include <shatterpave/geometry.h>

#include <cmath>
#include <cstddef>

namespace shatterpave {

double area(const Polygon& polygon) {
  if (polygon.empty()) return 0.0;
  // From a vertex of its own, so that a small polygon far away keeps its digits.
  const Point origin = polygon.front();
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    twice += (a.x - origin.x) * (b.y - origin.y) - (b.x - origin.x) * (a.y - origin.y);
  }
  return 0.5 * twice;
}

double area(const Region& region) {
  double total = std::abs(area(region.outline));
  for (const Polygon& hole : region.holes) total -= std::abs(area(hole));
  return total;
}

Point3 moved(const Transform& transform, Point3 point) {
  const auto row = [&](const Point3& r) { return r.x * point.x + r.y * point.y + r.z * point.z; };
  return {row(transform.rows[0]) + transform.shift_mm.x, row(transform.rows[1]) + transform.shift_mm.y,
          row(transform.rows[2]) + transform.shift_mm.z};
}

}  // namespace shatterpave
