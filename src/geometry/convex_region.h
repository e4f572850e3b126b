// What lies about a point, within a convex shape that is turned to a direction: a fan, a rectangle, a circle. For looks at all
// that is there; the nearest of much is found with less work in a Sector.
#pragma once

#include <optional>

#include "core/angle.h"
#include "core/vec.h"
#include "geometry/polygon.h"

namespace shatterpave::geometry {

// The shape, about the origin and turned to +x. Its border belongs to it.
class ConvexShape {
 public:
  //   opening  the whole angle of a fan with its apex in the origin, in (0°, 180°]
  //   radius   > 0, mm
  static ConvexShape sector(Angle opening, double radius);
  // Ahead of the origin, which is the middle of its near side; both > 0, mm.
  static ConvexShape rectangle(double length, double width);
  // About the origin.
  static ConvexShape circle(double radius);

 private:
  friend class ConvexRegion;
  // What the box, the circle and, if there is one, the fan have in common.
  vec2 low_{0.0, 0.0};
  vec2 high_{0.0, 0.0};
  double radius_ = 0.0;
  std::optional<vec2> left_;  // direction of the fan's left border; the right one mirrors it
};

class ConvexRegion {
 public:
  //   axis   of unit length
  //   shape  must outlive this
  ConvexRegion(vec2 origin, vec2 axis, const ConvexShape& shape);

  // A box about it.
  const Box& box() const { return box_; }
  bool contains(vec2 point) const;
  // The point nearest to the origin of the part of the segment that lies in the region.
  std::optional<vec2> nearest_point(vec2 a, vec2 b) const;

 private:
  vec2 local(vec2 point) const { return {glm::dot(axis_, point - origin_), cross(axis_, point - origin_)}; }

  vec2 origin_;
  vec2 axis_;
  const ConvexShape& shape_;
  Box box_;
};

}  // namespace shatterpave::geometry
