/// \file
/// Points, polygons and regions.
///
/// Lengths are millimetres in double precision. Points of the plane are x to the right and y up; points of space have z towards
/// the viewer (panes) or up (pavements). Both are right-handed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace shatterpave {

/// A point of the plane, mm.
struct Point {
  double x = 0.0;  ///< To the right.
  double y = 0.0;  ///< Up.

  /// To the bit.
  bool operator==(const Point&) const = default;
};

/// A point of space, mm; or a direction.
struct Point3 {
  double x = 0.0;  ///< To the right.
  double y = 0.0;  ///< Up in the plane.
  double z = 0.0;  ///< Out of the plane.

  /// To the bit.
  bool operator==(const Point3&) const = default;
};

/// A polygon: its vertices in order. The library returns simple ones, the first vertex not repeated at the end. It takes
/// polygons that run either way, also with repeated points; docs/scene-file.md tells what is refused.
using Polygon = std::vector<Point>;

/// A polygon with holes. Those that the library returns have their outline counter-clockwise and their holes clockwise; holes
/// lie inside, do not overlap, and may touch the outline or one another in single points.
struct Region {
  Polygon outline;             ///< The border without.
  std::vector<Polygon> holes;  ///< What is not part of it.

  /// Vertex by vertex, to the bit.
  bool operator==(const Region&) const = default;
};

/// A rigid motion: the point p goes to rows · p + shift_mm.
struct Transform {
  /// A turn: the rows of an orthogonal matrix of determinant 1.
  std::array<Point3, 3> rows{Point3{1.0, 0.0, 0.0}, Point3{0.0, 1.0, 0.0}, Point3{0.0, 0.0, 1.0}};
  Point3 shift_mm;  ///< What is added after the turn.

  /// To the bit.
  bool operator==(const Transform&) const = default;
};

/// Three indices of vertices, counter-clockwise as seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// Signed area of a polygon, mm²: positive where it runs counter-clockwise.
double area(const Polygon& polygon);
/// Area of the outline less those of the holes, mm², whichever way these run.
double area(const Region& region);

/// Where a motion takes a point.
Point3 moved(const Transform& transform, Point3 point);

}  // namespace shatterpave
