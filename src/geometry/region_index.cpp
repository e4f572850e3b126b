#include "geometry/region_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "geometry/corners.h"
#include "geometry/predicates.h"
#include "geometry/segment_distance.h"

namespace shatterpave::geometry {

namespace {

constexpr std::size_t leaf_size = 4;  // by trial: 2 to 8 make no difference that shows

Box box_of(const RegionIndex::Segment& s) {
  return {{std::min(s.from.x, s.to.x), std::min(s.from.y, s.to.y)}, {std::max(s.from.x, s.to.x), std::max(s.from.y, s.to.y)}};
}

Box joined(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

double square(double x) { return x * x; }

double squared_distance(const Box& box, vec2 p) {
  const double dx = std::max({box.low.x - p.x, 0.0, p.x - box.high.x});
  const double dy = std::max({box.low.y - p.y, 0.0, p.y - box.high.y});
  return square(dx) + square(dy);
}

double squared_length(vec2 v) { return glm::dot(v, v); }

// Separating axes of a segment and a box: x, y, and the segment's normal.
bool meets(const RegionIndex::Segment& s, const Box& box) {
  if (!boxes_meet(box_of(s), box)) return false;
  const vec2 d = s.to - s.from;
  bool left = false;
  bool right = false;
  for (const vec2& corner : corners(box)) {
    const double c = cross(d, corner - s.from);
    left = left || c >= 0.0;
    right = right || c <= 0.0;
  }
  return left && right;
}

void append_ring(std::vector<RegionIndex::Segment>& segments, const Polygon& ring, bool counter_clockwise) {
  const bool reversed = (area(ring) > 0.0) != counter_clockwise;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const vec2 a = on_lattice(ring[i]);
    const vec2 b = on_lattice(ring[(i + 1) % ring.size()]);
    if (a != b) segments.push_back(reversed ? RegionIndex::Segment{b, a} : RegionIndex::Segment{a, b});
  }
}

}  // namespace

vec2 nearest_point(const RegionIndex::Segment& s, vec2 p) { return nearest_on_segment(p, s.from, s.to); }

RegionIndex::RegionIndex(const Region& region) {
  append_ring(segments_, region.outline, true);
  for (const Polygon& hole : region.holes) append_ring(segments_, hole, false);
  ENSURE(segments_.size() >= 2 && segments_.size() < std::numeric_limits<std::uint32_t>::max());
  nodes_.reserve(segments_.size());
  build(0, segments_.size());
}

void RegionIndex::build(std::size_t begin, std::size_t end) {
  const std::size_t self = nodes_.size();
  Box box = box_of(segments_[begin]);
  for (std::size_t i = begin; i < end; ++i) box = joined(box, box_of(segments_[i]));
  nodes_.push_back({box, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin)});
  if (end - begin <= leaf_size) return;
  const bool by_x = box.high.x - box.low.x >= box.high.y - box.low.y;
  const auto key = [by_x](const Segment& s) { return by_x ? s.from.x + s.to.x : s.from.y + s.to.y; };
  const std::size_t middle = begin + (end - begin) / 2;
  std::stable_sort(segments_.begin() + static_cast<std::ptrdiff_t>(begin), segments_.begin() + static_cast<std::ptrdiff_t>(end),
                   [&](const Segment& a, const Segment& b) { return key(a) < key(b); });
  build(begin, middle);
  nodes_[self].first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[self].count = 0;
  build(middle, end);
}

bool RegionIndex::contains(vec2 point) const {
  const LatticePoint p = to_lattice(point);
  const vec2 at = to_mm(p);
  bool inside = false;
  std::array<std::uint32_t, 64> stack{};
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t n = stack[--depth];
    const Node& node = nodes_[n];
    // Only what lies to the right of the point, at its height, can cross a ray towards +x.
    if (node.box.high.x < at.x || node.box.low.y > at.y || node.box.high.y < at.y) continue;
    if (node.count == 0) {
      stack[depth++] = node.first;
      stack[depth++] = n + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const LatticePoint a = to_lattice(segments_[i].from);
      const LatticePoint b = to_lattice(segments_[i].to);
      if (on_segment(a, b, p)) return true;
      if ((a.y > p.y) != (b.y > p.y) && (b.y > a.y) == (side(a, b, p) == Side::left)) inside = !inside;
    }
  }
  return inside;
}

bool RegionIndex::border_meets(const Box& box) const {
  std::array<std::uint32_t, 64> stack{};
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t n = stack[--depth];
    const Node& node = nodes_[n];
    if (!boxes_meet(node.box, box)) continue;
    if (node.count == 0) {
      stack[depth++] = node.first;
      stack[depth++] = n + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (meets(segments_[i], box)) return true;
    }
  }
  return false;
}

bool RegionIndex::border_within(vec2 point, double distance_mm) const {
  return squared_distance(box(), point) <= square(distance_mm) && nearest(point).distance_mm <= distance_mm;
}

RegionIndex::Nearest RegionIndex::nearest(vec2 point) const {
  Nearest best;
  double best_squared = std::numeric_limits<double>::infinity();
  std::array<std::uint32_t, 64> stack{};
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t n = stack[--depth];
    const Node& node = nodes_[n];
    if (squared_distance(node.box, point) >= best_squared) continue;
    if (node.count == 0) {
      const bool left_first = squared_distance(nodes_[n + 1].box, point) <= squared_distance(nodes_[node.first].box, point);
      stack[depth++] = left_first ? node.first : n + 1;
      stack[depth++] = left_first ? n + 1 : node.first;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const vec2 on_border = nearest_point(segments_[i], point);
      const double d = squared_length(on_border - point);
      if (d < best_squared) {
        best_squared = d;
        best = {i, on_border, 0.0};
      }
    }
  }
  best.distance_mm = std::sqrt(best_squared);
  return best;
}

void RegionIndex::near(vec2 point, double distance_mm, std::vector<std::size_t>& found) const {
  std::array<std::uint32_t, 64> stack{};
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t n = stack[--depth];
    const Node& node = nodes_[n];
    if (squared_distance(node.box, point) > square(distance_mm)) continue;
    if (node.count == 0) {
      stack[depth++] = node.first;
      stack[depth++] = n + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (squared_length(nearest_point(segments_[i], point) - point) <= square(distance_mm)) found.push_back(i);
    }
  }
}

}  // namespace shatterpave::geometry
