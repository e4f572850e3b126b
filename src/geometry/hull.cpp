#include "geometry/hull.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>

namespace shatterpave::geometry {

Polygon convex_hull(const Polygon& polygon) {
  namespace bg = boost::geometry;
  using Point = bg::model::d2::point_xy<double>;
  bg::model::multi_point<Point> points;
  points.reserve(polygon.size());
  for (const vec2& p : polygon) points.emplace_back(p.x, p.y);
  bg::model::ring<Point, false, false> ring;
  bg::convex_hull(points, ring);
  Polygon hull;
  hull.reserve(ring.size());
  for (const Point& p : ring) hull.push_back({p.x(), p.y()});
  return hull;
}

}  // namespace shatterpave::geometry
