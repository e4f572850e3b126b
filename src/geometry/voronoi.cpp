#include "geometry/voronoi.h"

#include <algorithm>
#include <utility>

#include "geometry/delaunay.h"

namespace shatterpave::geometry {

namespace {

// The point as far from a as from b and c; their mean where they lie on one line.
vec2 circumcentre(vec2 a, vec2 b, vec2 c) {
  const vec2 p = b - a;
  const vec2 q = c - a;
  const double twice = 2.0 * cross(p, q);
  if (twice == 0.0) return (a + b + c) / 3.0;
  return a + vec2{q.y * glm::dot(p, p) - p.y * glm::dot(q, q), p.x * glm::dot(q, q) - q.x * glm::dot(p, p)} / twice;
}

}  // namespace

Polygon Voronoi::outline(std::size_t cell) const {
  Polygon polygon;
  for (const std::uint32_t corner : cells[cell]) polygon.push_back(corners[corner]);
  return polygon;
}

Voronoi voronoi(std::span<const vec2> seeds) {
  const Delaunay mesh = delaunay(seeds);
  Voronoi diagram{std::vector<vec2>(mesh.face_count), std::vector<std::vector<std::uint32_t>>(seeds.size())};
  std::vector<bool> known(mesh.face_count, false);
  for (std::size_t s = 0; s < seeds.size(); ++s) {
    const auto around = mesh.around(s);
    if (std::ranges::any_of(around, [](const Delaunay::Spoke& spoke) { return spoke.face == Delaunay::none; })) continue;
    for (std::size_t k = 0; k < around.size(); ++k) {
      const std::uint32_t face = around[k].face;
      diagram.cells[s].push_back(face);
      if (known[face]) continue;
      known[face] = true;
      diagram.corners[face] =
          circumcentre(seeds[s], seeds[around[k].neighbour], seeds[around[(k + 1) % around.size()].neighbour]);
    }
  }
  return diagram;
}

void sort_distinct(std::vector<vec2>& points) {
  std::ranges::sort(points, [](vec2 a, vec2 b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

}  // namespace shatterpave::geometry
