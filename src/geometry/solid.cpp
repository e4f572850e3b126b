#include "geometry/solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace shatterpave::geometry {

WideVolume sextuple_volume(const Solid& solid) {
  if (solid.vertices.empty()) return 0;
  const LatticePoint3 origin = solid.vertices.front();
  const auto from_origin = [&](std::uint32_t vertex) {
    const LatticePoint3& p = solid.vertices[vertex];
    return std::array<WideVolume, 3>{p.x - origin.x, p.y - origin.y, p.z - origin.z};
  };
  WideVolume sum = 0;
  for (const SolidTriangle& triangle : solid.triangles) {
    const auto [ax, ay, az] = from_origin(triangle.corners[0]);
    const auto [bx, by, bz] = from_origin(triangle.corners[1]);
    const auto [cx, cy, cz] = from_origin(triangle.corners[2]);
    sum += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return sum;
}

vec3 normal(const Solid& solid, const SolidTriangle& triangle) {
  const LatticePoint3& a = solid.vertices[triangle.corners[0]];
  const LatticePoint3& b = solid.vertices[triangle.corners[1]];
  const LatticePoint3& c = solid.vertices[triangle.corners[2]];
  const std::array<WideVolume, 3> p{b.x - a.x, b.y - a.y, b.z - a.z};
  const std::array<WideVolume, 3> q{c.x - a.x, c.y - a.y, c.z - a.z};
  // Exact up to here, so that no triangle is too thin.
  const vec3 across{static_cast<double>(p[1] * q[2] - p[2] * q[1]), static_cast<double>(p[2] * q[0] - p[0] * q[2]),
                    static_cast<double>(p[0] * q[1] - p[1] * q[0])};
  return across / std::sqrt(glm::dot(across, across));
}

bool is_closed(const Solid& solid) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(3 * solid.triangles.size());
  for (const SolidTriangle& triangle : solid.triangles) {
    for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(triangle.corners[i], triangle.corners[(i + 1) % 3]);
  }
  std::ranges::sort(edges);
  if (std::ranges::adjacent_find(edges) != edges.end()) return false;
  return std::ranges::all_of(edges, [&](const auto& edge) {
    return edge.first != edge.second && std::ranges::binary_search(edges, std::pair(edge.second, edge.first));
  });
}

}  // namespace shatterpave::geometry
