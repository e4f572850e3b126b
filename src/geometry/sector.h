// The fan in front of a point: apex, axis, opening, radius.
#pragma once

#include <optional>

#include "core/angle.h"
#include "core/vec.h"

namespace shatterpave::geometry {

// The shape of a sector, without its place and direction.
class SectorShape {
 public:
  //   opening  the whole angle, in (0°, 180°]: a convex fan
  //   radius   > 0, mm
  SectorShape(Angle opening, double radius);

 private:
  friend class Sector;
  vec2 half_;  // direction of the left border of the one whose axis is +x
  double radius_;
};

class Sector {
 public:
  //   axis  of unit length
  Sector(vec2 apex, vec2 axis, const SectorShape& shape);

  vec2 apex() const { return apex_; }
  double radius() const { return radius_; }

  struct Bounds {
    vec2 low;
    vec2 high;
  };
  // A box about the part of the sector that is no farther from its apex than `reach`.
  Bounds bounds(double reach) const { return {apex_ + reach * low_, apex_ + reach * high_}; }

  bool contains(vec2 point) const {
    const vec2 p = point - apex_;
    return cross(right_, p) >= 0.0 && cross(p, left_) >= 0.0 && glm::dot(p, p) <= radius_ * radius_;
  }
  // Whether the box may share a point with the part of the sector that is no farther from its apex than `reach`; false only
  // where it surely does not.
  bool may_meet(vec2 low, vec2 high, double reach) const;
  // The point nearest to the apex of the part of the segment that lies in the sector.
  std::optional<vec2> nearest_point(vec2 a, vec2 b) const;

 private:
  vec2 apex_;
  vec2 right_;  // direction of the right border; the sector lies to its left
  vec2 left_;
  vec2 low_;  // corners of a box about a sector of radius 1 at the origin
  vec2 high_;
  double radius_;
};

}  // namespace shatterpave::geometry
