#include "export/shapes/glass_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/angle.h"
#include "export/shapes/mesh_parts.h"

namespace shatterpave::exporting::shapes {

namespace {

// Sides of tubes, and of the disc of crushed glass.
constexpr std::size_t tube_sides = 6;
constexpr std::size_t disc_sides = 48;

// Along which axis a facet looks most.
std::size_t axis_of(vec3 normal) {
  const std::array<double, 3> parts{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  return static_cast<std::size_t>(std::ranges::max_element(parts) - parts.begin());
}

// Where a point is in a texture that is laid on from the side that the normal faces most squarely.
vec2 faced(vec3 p_mm, vec3 normal) {
  const std::size_t axis = axis_of(normal);
  const vec2 place = axis == 0 ? vec2{p_mm.y, p_mm.z} : (axis == 1 ? vec2{p_mm.x, p_mm.z} : vec2{p_mm.x, p_mm.y});
  return {metres(place.x), metres(place.y)};
}

// A flat facet with points of its own; nothing where it has no area.
void append_facet(Mesh& mesh, const std::array<vec3, 3>& corners) {
  const vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double size = glm::length(across);
  if (size == 0.0) return;
  const vec3 normal = across / size;
  const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
  for (const vec3& corner : corners) append_point(mesh, corner, normal, faced(corner, normal));
  append_triangle(mesh, first, first + 1, first + 2);
}

// ---- cavities: what bounds them looks into them

// Turns a closed surface inside out.
Mesh inverted(Mesh mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) std::swap(mesh.triangles[i + 1], mesh.triangles[i + 2]);
  for (vec3& normal : mesh.normals) normal = -normal;
  return mesh;
}

// Flat facets of a closed surface of triangles.
Mesh faceted(const std::vector<vec3>& points, const std::vector<std::size_t>& triangles) {
  Mesh mesh;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    append_facet(mesh, {points[triangles[i]], points[triangles[i + 1]], points[triangles[i + 2]]});
  }
  return mesh;
}

// The flat end over a ring of points, which are counter-clockwise about the axis; the normal looks along it or against it.
void append_end(Mesh& mesh, std::uint32_t ring, std::uint32_t count, vec3 normal) {
  const vec3 a = mesh.points_mm[ring];
  const bool along = glm::dot(glm::cross(mesh.points_mm[ring + 1] - a, mesh.points_mm[ring + 2] - a), normal) > 0.0;
  const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
  for (std::uint32_t k = 0; k < count; ++k) {
    const vec3 p = mesh.points_mm[ring + k];
    append_point(mesh, p, normal, faced(p, normal));
  }
  for (std::uint32_t k = 1; k + 1 < count; ++k) {
    append_triangle(mesh, first, first + (along ? k : k + 1), first + (along ? k + 1 : k));
  }
}

// Rings about an axis, closed at both ends by fans: a tube, or a disc.
Mesh round_body(vec3 from, vec3 to, vec3 side, double radius_mm, std::size_t sides) {
  const vec3 axis = glm::normalize(to - from);
  const vec3 other = glm::cross(axis, side);
  Mesh mesh;
  for (const double end : {0.0, 1.0}) {
    const vec3 middle = end == 0.0 ? from : to;
    for (std::size_t k = 0; k < sides; ++k) {
      const vec2 at = Angle::degrees(360.0 * static_cast<double>(k) / static_cast<double>(sides)).direction();
      const vec3 out = at.x * side + at.y * other;
      append_point(mesh, middle + radius_mm * out, out,
                   {metres(end * glm::length(to - from)),
                    metres(2.0 * pi * radius_mm * static_cast<double>(k) / static_cast<double>(sides))});
    }
  }
  const auto count = static_cast<std::uint32_t>(sides);
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t next = (k + 1) % count;
    append_triangle(mesh, k, next, count + next);
    append_triangle(mesh, k, count + next, count + k);
  }
  append_end(mesh, 0, count, -axis);
  append_end(mesh, count, count, axis);
  return inverted(std::move(mesh));
}

}  // namespace

Mesh gap_mesh(const glass::CrackSurface& surface) {
  Mesh mesh;
  const std::size_t wall = surface.left_mm.size();
  const std::size_t rows = surface.rows;
  for (const bool left : {true, false}) {
    const std::vector<vec3>& points = left ? surface.left_mm : surface.right_mm;
    double along = 0.0;
    for (std::size_t i = 0; i < wall; ++i) {
      if (i >= rows && i % rows == 0) along += glm::length(points[i] - points[i - rows]);
      append_point(mesh, points[i], left ? surface.normals[i] : -surface.normals[i], {metres(along), metres(points[i].z)});
    }
  }
  const std::vector<vec3> points = mesh.points_mm;
  const std::vector<std::size_t> triangles = glass::closed_triangles(surface);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const std::array<std::size_t, 3> c{triangles[i], triangles[i + 1], triangles[i + 2]};
    const auto on_left = std::ranges::count_if(c, [&](std::size_t corner) { return corner < wall; });
    if (on_left == 0 || on_left == 3) {
      append_triangle(mesh, static_cast<std::uint32_t>(c[0]), static_cast<std::uint32_t>(c[1]),
                      static_cast<std::uint32_t>(c[2]));
      continue;
    }
    // The rim between the walls is sharp.
    append_facet(mesh, {points[c[0]], points[c[1]], points[c[2]]});
  }
  return inverted(std::move(mesh));
}

Mesh tube_mesh(const Tube& tube) {
  return round_body({tube.a_mm, tube.z_mm}, {tube.b_mm, tube.z_mm}, {0.0, 0.0, 1.0}, tube.radius_mm, tube_sides);
}

Mesh crushed_mesh(const glass::ImpactZone& zone, double half_mm) {
  const vec2 at = zone.centre_mm;
  return round_body({at.x, at.y, -half_mm}, {at.x, at.y, half_mm}, {1.0, 0.0, 0.0}, zone.radius_mm, disc_sides);
}

Mesh hole_mesh(const glass::ShotHole& hole) {
  std::vector<vec3> points = hole.wall_mm;
  for (const vec3& middle : glass::middles_mm(hole)) points.push_back(middle);
  return inverted(faceted(points, glass::closed_triangles(hole)));
}

Mesh slab_mesh(const glass::Pane& pane) {
  const double half = 0.5 * pane.thickness_mm;
  return upright_prism({pane.outline_mm, {}}, -half, half);
}

Mesh shard_mesh(const glass::Shard& shard, glass::ShardSurface slot, double thickness_mm) {
  Mesh mesh;
  for (const geometry::SolidTriangle& triangle : shard.solid.triangles) {
    if (triangle.slot != static_cast<int>(slot)) continue;
    const vec3 normal = geometry::normal(shard.solid, triangle);
    const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
    for (const std::uint32_t corner : triangle.corners) {
      const vec3 p = glass::in_pane_mm(shard.solid.vertices[corner], thickness_mm);
      append_point(mesh, p, normal, faced(p, normal));
    }
    append_triangle(mesh, first, first + 1, first + 2);
  }
  return mesh;
}

Mesh bent(Mesh mesh, const geometry::Bend& bend, double bound_mm) {
  if (bend.is_flat()) return mesh;
  std::vector<std::array<std::uint32_t, 3>> triangles(mesh.triangles.size() / 3);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) triangles[i / 3].at(i % 3) = mesh.triangles[i];
  const geometry::Refinement parts = geometry::refinement(mesh.points_mm, triangles, bend, bound_mm);
  for (const auto [a, b] : parts.added) {
    append_point(mesh, 0.5 * (mesh.points_mm[a] + mesh.points_mm[b]), glm::normalize(mesh.normals[a] + mesh.normals[b]),
                 0.5 * (mesh.uv_m[a] + mesh.uv_m[b]));
  }
  mesh.triangles.clear();
  for (const auto& corners : parts.triangles) append_triangle(mesh, corners[0], corners[1], corners[2]);
  for (std::size_t i = 0; i < mesh.points_mm.size(); ++i) {
    mesh.normals[i] = bend.normal(mesh.points_mm[i], mesh.normals[i]);
    mesh.points_mm[i] = bend.point(mesh.points_mm[i]);
  }
  return mesh;
}

}  // namespace shatterpave::exporting::shapes
