// Holes are joined to the outline by bridges, walked both ways, so that one ring is left. An ear is three vertices in
// succession, the middle one convex, whose outer two see each other: the way between them crosses no side, passes through no
// vertex, and leaves both into the inside. An ear can always be cut off, and what is left is such a ring again. Bridges make
// some vertices occur twice, so what can be seen is asked from a corner of the ring, not from its point.
#include "geometry/triangulation.h"

#include <algorithm>
#include <numeric>

#include "core/error.h"
#include "geometry/predicates.h"

namespace shatterpave::geometry {

namespace {

__extension__ using Wide = __int128;

class Ears {
 public:
  explicit Ears(std::span<const std::vector<LatticePoint>> rings);
  std::vector<TriangleCorners> cut();

 private:
  using Ring = std::vector<std::size_t>;

  LatticePoint at(std::size_t vertex) const { return points_[vertex]; }
  bool in_cone(const Ring& ring, std::size_t corner, LatticePoint p) const;
  bool blocks(const Ring& ring, LatticePoint a, LatticePoint c) const;
  bool is_ear(std::size_t corner) const;
  void join(const Ring& hole, std::span<const Ring> others);

  std::vector<LatticePoint> points_;
  std::vector<Ring> holes_;
  Ring ring_;
};

Ears::Ears(std::span<const std::vector<LatticePoint>> rings) {
  for (const std::vector<LatticePoint>& points : rings) {
    Ring ring(points.size());
    std::iota(ring.begin(), ring.end(), points_.size());
    points_.insert(points_.end(), points.begin(), points.end());
    if (ring_.empty()) {
      ring_ = std::move(ring);
    } else {
      holes_.push_back(std::move(ring));
    }
  }
  const auto rightmost = [&](const Ring& ring) {
    return *std::ranges::max_element(ring, {}, [&](std::size_t v) { return at(v); });
  };
  std::ranges::sort(holes_, [&](const Ring& p, const Ring& q) { return at(rightmost(p)) > at(rightmost(q)); });
  for (std::size_t i = 0; i < holes_.size(); ++i) join(holes_[i], std::span(holes_).subspan(i));
}

// Whether the way from a corner of the ring to `p` leaves it into the inside.
bool Ears::in_cone(const Ring& ring, std::size_t corner, LatticePoint p) const {
  const std::size_t n = ring.size();
  const LatticePoint before = at(ring[(corner + n - 1) % n]);
  const LatticePoint o = at(ring[corner]);
  const LatticePoint after = at(ring[(corner + 1) % n]);
  if (side(before, o, after) == Side::left) return side(o, after, p) == Side::left && side(before, o, p) == Side::left;
  return side(o, after, p) == Side::left || side(before, o, p) == Side::left;
}

// Whether the ring meets the way from a to c other than at its ends.
bool Ears::blocks(const Ring& ring, LatticePoint a, LatticePoint c) const {
  const auto [low_x, high_x] = std::minmax(a.x, c.x);
  const auto [low_y, high_y] = std::minmax(a.y, c.y);
  LatticePoint p = at(ring.back());
  for (const std::size_t vertex : ring) {
    const LatticePoint q = at(vertex);
    const bool beside =
        std::max(p.x, q.x) < low_x || std::min(p.x, q.x) > high_x || std::max(p.y, q.y) < low_y || std::min(p.y, q.y) > high_y;
    if (!beside) {
      if (q != a && q != c && on_segment(a, c, q)) return true;
      if (segments_cross(a, c, p, q)) return true;
    }
    p = q;
  }
  return false;
}

bool Ears::is_ear(std::size_t corner) const {
  const std::size_t n = ring_.size();
  const std::size_t before = (corner + n - 1) % n;
  const std::size_t after = (corner + 1) % n;
  const LatticePoint a = at(ring_[before]);
  const LatticePoint c = at(ring_[after]);
  if (side(a, at(ring_[corner]), c) != Side::left) return false;
  if (n == 3) return true;
  return in_cone(ring_, before, c) && in_cone(ring_, after, a) && !blocks(ring_, a, c);
}

// Bridges a hole, which lies farther towards −x than those joined before, to the ring, from its rightmost vertex to the nearest
// one that sees it. `others` are the holes that are not joined yet, with this one.
void Ears::join(const Ring& hole, std::span<const Ring> others) {
  const auto start = std::ranges::max_element(hole, {}, [&](std::size_t v) { return at(v); });
  const std::size_t first = static_cast<std::size_t>(start - hole.begin());
  const LatticePoint h = at(*start);
  const auto distance = [&](std::size_t corner) {
    const Wide x = at(ring_[corner]).x - h.x;
    const Wide y = at(ring_[corner]).y - h.y;
    return x * x + y * y;
  };
  std::vector<std::size_t> corners(ring_.size());
  std::iota(corners.begin(), corners.end(), 0);
  std::ranges::stable_sort(corners, [&](std::size_t p, std::size_t q) { return distance(p) < distance(q); });
  const auto seen = std::ranges::find_if(corners, [&](std::size_t corner) {
    const LatticePoint p = at(ring_[corner]);
    return in_cone(ring_, corner, h) && in_cone(hole, first, p) && !blocks(ring_, p, h) &&
           std::ranges::none_of(others, [&](const Ring& other) { return blocks(other, p, h); });
  });
  ENSURE(seen != corners.end());
  Ring way;
  for (std::size_t i = 0; i <= hole.size(); ++i) way.push_back(hole[(first + i) % hole.size()]);
  way.push_back(ring_[*seen]);
  ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(*seen) + 1, way.begin(), way.end());
}

std::vector<TriangleCorners> Ears::cut() {
  std::vector<TriangleCorners> triangles;
  std::size_t corner = 0;
  std::size_t tried = 0;
  while (ring_.size() >= 3) {
    const std::size_t n = ring_.size();
    ENSURE(tried < n);
    corner %= n;
    if (!is_ear(corner)) {
      ++corner;
      ++tried;
      continue;
    }
    triangles.push_back({ring_[(corner + n - 1) % n], ring_[corner], ring_[(corner + 1) % n]});
    if (n == 3) break;
    ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(corner));
    // Going on beside the ear keeps its neighbour for later: fans of thin triangles are rarer so.
    tried = 0;
    ++corner;
  }
  return triangles;
}

}  // namespace

std::vector<TriangleCorners> triangulation(std::span<const std::vector<LatticePoint>> rings) { return Ears(rings).cut(); }

std::vector<std::vector<LatticePoint>> lattice_rings(const Region& region) {
  std::vector<std::vector<LatticePoint>> rings;
  const auto add = [&](const Polygon& polygon) {
    std::vector<LatticePoint>& ring = rings.emplace_back();
    ring.reserve(polygon.size());
    for (const vec2& p : polygon) ring.push_back(to_lattice(p));
  };
  add(region.outline);
  for (const Polygon& hole : region.holes) add(hole);
  return rings;
}

}  // namespace shatterpave::geometry
