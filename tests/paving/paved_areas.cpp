#include "paving/paved_areas.h"

#include <algorithm>

#include "geometry/lattice.h"

namespace shatterpave::paving {

namespace {

geometry::Polygon arc(vec2 centre, double radius_mm, Angle from, Angle to, int steps) {
  geometry::Polygon points;
  for (int i = 0; i <= steps; ++i) {
    const Angle at = from + (static_cast<double>(i) / steps) * (to - from);
    points.push_back(geometry::on_lattice(centre + radius_mm * at.direction()));
  }
  return points;
}

}  // namespace

geometry::Polygon circle(vec2 centre, double radius_mm, int corners) {
  geometry::Polygon points = arc(centre, radius_mm, Angle(), Angle::degrees(360.0), corners);
  points.pop_back();
  return points;
}

geometry::Region path_area() { return {{{0, 0}, {4000, 0}, {4000, 1200}, {0, 1200}}, {{{500, 500}, {700, 700}, {700, 500}}}}; }

geometry::Region quarter_annulus() {
  geometry::Region region;
  region.outline = arc({0, 0}, 10000.0, Angle(), Angle::degrees(90.0), 200);
  const auto inner = arc({0, 0}, 4000.0, Angle::degrees(90.0), Angle(), 200);
  region.outline.insert(region.outline.end(), inner.begin(), inner.end());
  return region;
}

geometry::Region concave_area() {
  geometry::Polygon hole = circle({1700, 2600}, 600.0, 24);
  std::ranges::reverse(hole);
  return {{{0, 0}, {6000, 0}, {6000, 2500}, {3500, 2500}, {3000, 3200}, {3500, 5000}, {500, 5500}, {-500, 2500}}, {hole}};
}

Pavement pavement(geometry::Region area, double stone_mm, double joint_mm, Direction direction) {
  Pavement result;
  result.name = "test";
  result.area = std::move(area);
  result.stone_mm = {stone_mm, stone_mm};
  result.joint_mm = joint_mm;
  result.direction = std::move(direction);
  return result;
}

}  // namespace shatterpave::paving
