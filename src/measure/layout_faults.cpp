// Stones side by side are nearly always parted by the line of one of their sides, which takes a few exact tests to see; only
// where there is no such side are all pairs of sides compared.
#include "measure/layout_faults.h"

#include <algorithm>

#include "core/parallel.h"
#include "geometry/clip.h"
#include "geometry/predicates.h"

namespace shatterpave::measure {

namespace {

using geometry::Box;
using geometry::LatticePoint;
using geometry::Polygon;
using geometry::Side;
using geometry::to_lattice;

constexpr std::size_t chunk = 512;  // stones

bool is_valid(const Polygon& polygon) {
  if (polygon.size() < 3 || geometry::area(polygon) <= 0.0 || !geometry::is_simple(polygon)) return false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (geometry::on_lattice(polygon[i]) != polygon[i]) return false;
    const LatticePoint a = to_lattice(polygon[i]);
    const LatticePoint b = to_lattice(polygon[(i + 1) % polygon.size()]);
    if (geometry::side(a, b, to_lattice(polygon[(i + 2) % polygon.size()])) == Side::on) return false;
  }
  return true;
}

std::vector<LatticePoint> lattice_points(const Polygon& polygon) {
  std::vector<LatticePoint> points;
  points.reserve(polygon.size());
  for (const vec2& p : polygon) points.push_back(to_lattice(p));
  return points;
}

// Whether the line of a side of `a` has all of `a` to its left or on it, and all of `b` to its right.
bool parted_by_side(const std::vector<LatticePoint>& a, const std::vector<LatticePoint>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const LatticePoint from = a[i];
    const LatticePoint to = a[(i + 1) % a.size()];
    const auto is_right = [&](LatticePoint p) { return geometry::side(from, to, p) == Side::right; };
    if (std::ranges::all_of(b, is_right) && std::ranges::none_of(a, is_right)) return true;
  }
  return false;
}

bool have_common_point(const Polygon& a, const Polygon& b) {
  const auto p = lattice_points(a);
  const auto q = lattice_points(b);
  if (parted_by_side(p, q) || parted_by_side(q, p)) return false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      if (geometry::segments_meet(p[i], p[(i + 1) % p.size()], q[j], q[(j + 1) % q.size()])) return true;
    }
  }
  return geometry::contains(a, b.front()) || geometry::contains(b, a.front());
}

bool leaves(const Polygon& stone, const Box& box, const geometry::RegionIndex& area, std::vector<std::size_t>& near) {
  if (!area.border_meets(box)) return !area.contains(stone.front());
  if (!std::ranges::all_of(stone, [&](vec2 p) { return area.contains(p); })) return true;
  near.clear();
  area.near(0.5 * (box.low + box.high), glm::length(box.high - box.low), near);
  return std::ranges::any_of(near, [&](std::size_t s) {
    const auto& border = area.segments()[s];
    const LatticePoint from = to_lattice(border.from);
    const LatticePoint to = to_lattice(border.to);
    // A corner of the border inside the stone, or a border that crosses its side.
    if (geometry::contains(stone, border.from)) return true;
    for (std::size_t i = 0; i < stone.size(); ++i) {
      if (geometry::segments_cross(to_lattice(stone[i]), to_lattice(stone[(i + 1) % stone.size()]), from, to)) return true;
    }
    return false;
  });
}

}  // namespace

LayoutFaults layout_faults(const paving::StoneLayout& layout, const StoneIndex& index, const geometry::RegionIndex& area) {
  const std::size_t count = layout.stones.size();
  std::vector<LayoutFaults> parts((count + chunk - 1) / chunk);
  parallel_for_chunks(count, chunk, [&](std::size_t begin, std::size_t end) {
    LayoutFaults& part = parts[begin / chunk];
    std::vector<std::size_t> near;
    for (std::size_t s = begin; s < end; ++s) {
      const Polygon& stone = layout.stones[s].outline_mm;
      if (!is_valid(stone)) ++part.invalid;
      if (leaves(stone, index.box(s), area, near)) ++part.outside;
      index.near(index.box(s), near);
      for (const std::size_t t : near) {
        if (t > s && have_common_point(stone, layout.stones[t].outline_mm)) ++part.overlaps;
      }
    }
  });
  LayoutFaults all;
  for (const LayoutFaults& part : parts) {
    all.invalid += part.invalid;
    all.overlaps += part.overlaps;
    all.outside += part.outside;
  }
  return all;
}

}  // namespace shatterpave::measure
