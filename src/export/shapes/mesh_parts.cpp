#include "export/shapes/mesh_parts.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "geometry/triangulation.h"

namespace shatterpave::exporting::shapes {

namespace {

void append_cap(Mesh& mesh, const geometry::Region& region, double z, bool is_top) {
  const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
  const vec3 normal{0.0, 0.0, is_top ? 1.0 : -1.0};
  const auto append_ring = [&](const geometry::Polygon& ring) {
    for (const vec2& p : ring) append_point(mesh, {p.x, p.y, z}, normal, {metres(p.x), metres(p.y)});
  };
  append_ring(region.outline);
  for (const geometry::Polygon& hole : region.holes) append_ring(hole);
  for (const geometry::TriangleCorners& corners : geometry::triangulation(geometry::lattice_rings(region))) {
    std::array<std::uint32_t, 3> c{};
    for (std::size_t k = 0; k < 3; ++k) c.at(k) = first + static_cast<std::uint32_t>(corners.at(k));
    append_triangle(mesh, c[0], is_top ? c[1] : c[2], is_top ? c[2] : c[1]);
  }
}

// Of an outline that runs counter-clockwise, or of a hole that runs clockwise: the solid is on the left.
void append_sides(Mesh& mesh, const geometry::Polygon& ring, double low, double high) {
  double along = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const vec2 a = ring[i];
    const vec2 b = ring[(i + 1) % ring.size()];
    const double length = glm::length(b - a);
    const vec2 out = -left_of((b - a) / length);
    const vec3 normal{out.x, out.y, 0.0};
    const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
    append_point(mesh, {a.x, a.y, low}, normal, {metres(along), metres(low)});
    append_point(mesh, {b.x, b.y, low}, normal, {metres(along + length), metres(low)});
    append_point(mesh, {b.x, b.y, high}, normal, {metres(along + length), metres(high)});
    append_point(mesh, {a.x, a.y, high}, normal, {metres(along), metres(high)});
    append_triangle(mesh, first, first + 1, first + 2);
    append_triangle(mesh, first, first + 2, first + 3);
    along += length;
  }
}

}  // namespace

void append_point(Mesh& mesh, vec3 p_mm, vec3 normal, vec2 uv_m) {
  mesh.points_mm.push_back(p_mm);
  mesh.normals.push_back(normal);
  mesh.uv_m.push_back(uv_m);
}

void append_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
}

void append(Mesh& mesh, const Mesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
  mesh.points_mm.insert(mesh.points_mm.end(), more.points_mm.begin(), more.points_mm.end());
  mesh.normals.insert(mesh.normals.end(), more.normals.begin(), more.normals.end());
  mesh.uv_m.insert(mesh.uv_m.end(), more.uv_m.begin(), more.uv_m.end());
  for (const std::uint32_t corner : more.triangles) mesh.triangles.push_back(first + corner);
}

Mesh welded(const Mesh& mesh) {
  // 0.1 µm, a thousandth of a unit vector, and 1 µm.
  constexpr std::array steps = {1e4, 1e3, 1e6};
  std::map<std::array<std::int64_t, 8>, std::uint32_t> known;
  std::vector<std::uint32_t> numbers(mesh.points_mm.size());
  Mesh result;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const vec3& p = mesh.points_mm[i];
    const vec3& n = mesh.normals[i];
    const vec2& uv = mesh.uv_m[i];
    const std::array<std::int64_t, 8> key{std::llround(steps[0] * p.x),  std::llround(steps[0] * p.y),
                                          std::llround(steps[0] * p.z),  std::llround(steps[1] * n.x),
                                          std::llround(steps[1] * n.y),  std::llround(steps[1] * n.z),
                                          std::llround(steps[2] * uv.x), std::llround(steps[2] * uv.y)};
    const auto [found, is_new] = known.try_emplace(key, static_cast<std::uint32_t>(result.points_mm.size()));
    if (is_new) append_point(result, p, n, uv);
    numbers[i] = found->second;
  }
  result.triangles.reserve(mesh.triangles.size());
  for (const std::uint32_t corner : mesh.triangles) result.triangles.push_back(numbers[corner]);
  return result;
}

Mesh upright_cap(const geometry::Region& region, double z_mm) {
  Mesh mesh;
  append_cap(mesh, region, z_mm, true);
  return mesh;
}

Mesh upright_sides(const geometry::Polygon& outline, double low_mm, double high_mm) {
  Mesh mesh;
  append_sides(mesh, outline, low_mm, high_mm);
  return mesh;
}

Mesh upright_prism(const geometry::Region& region, double low_mm, double high_mm) {
  Mesh mesh;
  append_cap(mesh, region, high_mm, true);
  append_cap(mesh, region, low_mm, false);
  append_sides(mesh, region.outline, low_mm, high_mm);
  for (const geometry::Polygon& hole : region.holes) append_sides(mesh, hole, low_mm, high_mm);
  return mesh;
}

}  // namespace shatterpave::exporting::shapes
