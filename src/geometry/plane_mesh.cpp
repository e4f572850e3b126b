// Lawson, "Software for C1 surface interpolation", 1977: an edge whose two opposite angles make more than half a turn is
// flipped, again and again; with edges that stay the end is the constrained Delaunay triangulation (Lee and Lin 1986).
#include "geometry/plane_mesh.h"

#include <algorithm>

#include "geometry/predicates.h"

namespace shatterpave::geometry {

namespace {

__extension__ using Wide = __int128;

// Whether the angles at c and d, on either side of the edge a b, make more than half a turn: the sine of their sum is below
// zero. Each factor is at most the product of two sides, so that for coordinates within ±1 km all stays below 2^127.
bool is_to_flip(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const auto dot = [](LatticePoint o, LatticePoint p, LatticePoint q) {
    return static_cast<Wide>(p.x - o.x) * (q.x - o.x) + static_cast<Wide>(p.y - o.y) * (q.y - o.y);
  };
  const auto cross = [](LatticePoint o, LatticePoint p, LatticePoint q) {
    return static_cast<Wide>(p.x - o.x) * (q.y - o.y) - static_cast<Wide>(p.y - o.y) * (q.x - o.x);
  };
  return cross(c, a, b) * dot(d, b, a) + dot(c, a, b) * cross(d, b, a) < 0;
}

}  // namespace

PlaneMesh::PlaneMesh(std::span<const std::vector<LatticePoint>> rings) {
  for (const std::vector<LatticePoint>& ring : rings) points_.insert(points_.end(), ring.begin(), ring.end());
  const std::vector<TriangleCorners> triangles = triangulation(rings);
  triangles_.resize(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) put(i, triangles[i]);
}

void PlaneMesh::put(std::size_t triangle, const TriangleCorners& corners) {
  triangles_[triangle] = corners;
  for (std::size_t i = 0; i < 3; ++i) on_left_[key(corners[i], corners[(i + 1) % 3])] = triangle;
}

std::optional<std::size_t> PlaneMesh::triangle_at(std::size_t a, std::size_t b) const {
  const auto found = on_left_.find(key(a, b));
  if (found == on_left_.end()) return std::nullopt;
  return found->second;
}

std::optional<std::size_t> PlaneMesh::apex(std::size_t a, std::size_t b) const {
  const auto triangle = triangle_at(a, b);
  if (!triangle) return std::nullopt;
  const TriangleCorners& corners = triangles_[*triangle];
  return *std::ranges::find_if(corners, [&](std::size_t corner) { return corner != a && corner != b; });
}

bool PlaneMesh::is_left_turn(std::size_t a, std::size_t b, std::size_t c) const {
  return side(points_[a], points_[b], points_[c]) == Side::left;
}

bool PlaneMesh::flip(std::size_t a, std::size_t b) {
  const auto c = apex(a, b);
  const auto d = apex(b, a);
  if (!c || !d || !is_left_turn(a, *d, *c) || !is_left_turn(*d, b, *c)) return false;
  const std::size_t left = on_left_.at(key(a, b));
  const std::size_t right = on_left_.at(key(b, a));
  on_left_.erase(key(a, b));
  on_left_.erase(key(b, a));
  put(left, {a, *d, *c});
  put(right, {*d, b, *c});
  return true;
}

std::optional<std::size_t> PlaneMesh::part(std::size_t a, std::size_t b, LatticePoint point) {
  const auto c = apex(a, b);
  const auto d = apex(b, a);
  if (!c || !d) return std::nullopt;
  const std::size_t middle = points_.size();
  points_.push_back(point);
  if (!is_left_turn(a, middle, *c) || !is_left_turn(middle, b, *c) || !is_left_turn(b, middle, *d) ||
      !is_left_turn(middle, a, *d)) {
    points_.pop_back();
    return std::nullopt;
  }
  const std::size_t left = on_left_.at(key(a, b));
  const std::size_t right = on_left_.at(key(b, a));
  on_left_.erase(key(a, b));
  on_left_.erase(key(b, a));
  triangles_.resize(triangles_.size() + 2);
  put(left, {a, middle, *c});
  put(triangles_.size() - 2, {middle, b, *c});
  put(right, {b, middle, *d});
  put(triangles_.size() - 1, {middle, a, *d});
  return middle;
}

std::optional<std::size_t> PlaneMesh::part(std::size_t triangle, LatticePoint point) {
  const auto [a, b, c] = triangles_[triangle];
  const std::size_t middle = points_.size();
  points_.push_back(point);
  if (!is_left_turn(a, b, middle) || !is_left_turn(b, c, middle) || !is_left_turn(c, a, middle)) {
    points_.pop_back();
    return std::nullopt;
  }
  triangles_.resize(triangles_.size() + 2);
  put(triangle, {a, b, middle});
  put(triangles_.size() - 2, {b, c, middle});
  put(triangles_.size() - 1, {c, a, middle});
  return middle;
}

void PlaneMesh::make_delaunay() {
  std::vector<std::array<std::size_t, 2>> doubtful;
  for (const TriangleCorners& corners : triangles_) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (corners[i] < corners[(i + 1) % 3]) doubtful.push_back({corners[i], corners[(i + 1) % 3]});
    }
  }
  while (!doubtful.empty()) {
    const auto [a, b] = doubtful.back();
    doubtful.pop_back();
    const auto c = apex(a, b);
    const auto d = apex(b, a);
    if (!c || !d || !is_to_flip(points_[a], points_[b], points_[*c], points_[*d]) || !flip(a, b)) continue;
    for (const auto& edge : {std::array{a, *c}, std::array{*c, b}, std::array{b, *d}, std::array{*d, a}})
      doubtful.push_back(edge);
  }
}

}  // namespace shatterpave::geometry
