// The fan in front of a point: apex, axis, opening, radius.
#pragma once

#include <optional>

#include "core/angle.h"
#include "core/vec.h"

namespace shatterpave::geometry {

class Sector {
 public:
  //   axis     of unit length
  //   opening  the whole angle, in (0°, 180°]: a convex fan
  //   radius   > 0, mm
  Sector(vec2 apex, vec2 axis, Angle opening, double radius);

  vec2 apex() const { return apex_; }
  double radius() const { return radius_; }

  bool contains(vec2 point) const;
  // Whether the box may share a point with the sector; false only where it surely does not.
  bool may_meet(vec2 low, vec2 high) const;
  // The point nearest to the apex of the part of the segment that lies in the sector.
  std::optional<vec2> nearest_point(vec2 a, vec2 b) const;

 private:
  vec2 apex_;
  vec2 right_;  // direction of the right border; the sector lies to its left
  vec2 left_;
  double radius_;
};

}  // namespace shatterpave::geometry
