// Points, polygons and regions of the face from those of the rooms.
#pragma once

#include <shatterpave/geometry.h>

#include <vector>

#include "core/vec.h"
#include "geometry/polygon.h"

namespace shatterpave::face {

inline Point plain(vec2 p) { return {p.x, p.y}; }
inline Point3 plain(vec3 p) { return {p.x, p.y, p.z}; }

inline Polygon plain(const std::vector<vec2>& points) {
  Polygon result;
  result.reserve(points.size());
  for (const vec2& p : points) result.push_back(plain(p));
  return result;
}

inline Region plain(const geometry::Region& region) {
  Region result{plain(region.outline), {}};
  result.holes.reserve(region.holes.size());
  for (const geometry::Polygon& hole : region.holes) result.holes.push_back(plain(hole));
  return result;
}

}  // namespace shatterpave::face
