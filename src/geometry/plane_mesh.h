// Meshes of triangles in the plane that are improved by flipping and splitting edges, exactly on the lattice.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/triangulation.h"

namespace shatterpave::geometry {

// Triangles, counter-clockwise and with an area, no two of which overlap. Whatever is done to them, they cover the same points,
// but for the 1 µm by which a point that parts an edge may lie beside it; edges with a triangle on one side only stay.
class PlaneMesh {
 public:
  // The region between rings, as `triangulation` divides it.
  explicit PlaneMesh(std::span<const std::vector<LatticePoint>> rings);

  const std::vector<LatticePoint>& points() const { return points_; }
  const std::vector<TriangleCorners>& triangles() const { return triangles_; }

  // The triangle on the left of the edge from a to b, and its third corner; nothing where there is no such edge or triangle.
  std::optional<std::size_t> triangle_at(std::size_t a, std::size_t b) const;
  std::optional<std::size_t> apex(std::size_t a, std::size_t b) const;

  // Replaces an edge by the other diagonal of the two triangles at it. Does nothing, and returns false, if the edge has one
  // triangle only or the two make no strictly convex quadrangle.
  bool flip(std::size_t a, std::size_t b);

  // Puts a new point into an edge between two triangles, which become four. Returns its number. Does nothing, and returns none,
  // if one of the four would be turned over or without area.
  std::optional<std::size_t> part(std::size_t a, std::size_t b, LatticePoint point);

  // Puts a new point into a triangle, which becomes three. Returns its number; none, and nothing is done, if it lies outside.
  std::optional<std::size_t> part(std::size_t triangle, LatticePoint point);

  // Flips edges until the mesh is a constrained Delaunay triangulation of its region: the circle about each triangle has no
  // vertex within it that is seen from the triangle. So none is thinner than what it lies in. Exact.
  void make_delaunay();

 private:
  using EdgeKey = std::uint64_t;
  static EdgeKey key(std::size_t a, std::size_t b) { return (static_cast<EdgeKey>(a) << 32U) | b; }

  void put(std::size_t triangle, const TriangleCorners& corners);
  bool is_left_turn(std::size_t a, std::size_t b, std::size_t c) const;

  std::vector<LatticePoint> points_;
  std::vector<TriangleCorners> triangles_;
  std::unordered_map<EdgeKey, std::size_t> on_left_;  // of directed edges: looked up, never walked through
};

}  // namespace shatterpave::geometry
