// The middle of the largest circle is as far from three places of the border: a vertex of the Voronoi diagram of its sides. The
// diagram asks for sides that meet in their ends alone. So sides are parted where others end on them, and those that lie on
// each other become one; where some still cross, which only rounding makes of a region's sides, the diagram is that of points
// along them.
#include "geometry/inscribed_circle.h"

#include <algorithm>
#include <boost/polygon/point_data.hpp>
#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/predicates.h"
#include "geometry/region_index.h"

namespace shatterpave::geometry {

namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using SitePoint = boost::polygon::point_data<std::int32_t>;
using Piece = std::pair<LatticePoint, LatticePoint>;  // the lesser end first

constexpr double half_step_mm = 0.5 / lattice_per_mm;
// Spacing of the points that stand for a side. They are off by at most half of it, and by less where the circle is wide.
constexpr double point_spacing_mm = 2.0 * circle_tolerance_mm;
constexpr double most_points = 200'000.0;

Piece ordered(LatticePoint a, LatticePoint b) { return a < b ? Piece{a, b} : Piece{b, a}; }

// The sides, parted where corners lie on them, each once.
std::vector<Piece> parted_sides(const RegionIndex& border) {
  const auto& segments = border.segments();
  std::vector<std::vector<LatticePoint>> on(segments.size());
  std::vector<std::size_t> near;
  for (const auto& segment : segments) {
    near.clear();
    border.near(segment.from, half_step_mm, near);
    const LatticePoint corner = to_lattice(segment.from);
    for (const std::size_t n : near) {
      const LatticePoint a = to_lattice(segments[n].from);
      const LatticePoint b = to_lattice(segments[n].to);
      if (corner != a && corner != b && on_segment(a, b, corner)) on[n].push_back(corner);
    }
  }
  std::vector<Piece> sides;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Piece whole = ordered(to_lattice(segments[s].from), to_lattice(segments[s].to));
    if (whole.first == whole.second) continue;
    std::ranges::sort(on[s]);
    LatticePoint from = whole.first;
    for (const LatticePoint corner : on[s]) {
      if (corner != from) sides.emplace_back(from, corner);
      from = corner;
    }
    sides.emplace_back(from, whole.second);
  }
  std::ranges::sort(sides);
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  return sides;
}

bool some_cross(const RegionIndex& border) {
  const auto& segments = border.segments();
  std::vector<std::size_t> near;
  return std::ranges::any_of(segments, [&](const RegionIndex::Segment& s) {
    near.clear();
    border.near(0.5 * (s.from + s.to), 0.5 * glm::length(s.to - s.from) + half_step_mm, near);
    return std::ranges::any_of(near, [&](std::size_t n) {
      return segments_cross(to_lattice(s.from), to_lattice(s.to), to_lattice(segments[n].from), to_lattice(segments[n].to));
    });
  });
}

// Of coordinates that 32 bits hold.
class SiteFrame {
 public:
  explicit SiteFrame(const Box& box) : origin_(to_lattice(0.5 * (box.low + box.high))) {}

  SitePoint site(LatticePoint p) const {
    return {static_cast<std::int32_t>(p.x - origin_.x), static_cast<std::int32_t>(p.y - origin_.y)};
  }
  vec2 place(const Diagram::vertex_type& vertex) const {
    return to_mm(origin_) + vec2{vertex.x(), vertex.y()} / lattice_per_mm;
  }

 private:
  LatticePoint origin_;
};

std::vector<SitePoint> points_along(const std::vector<Piece>& sides, const SiteFrame& frame) {
  double length = 0.0;
  for (const auto& [a, b] : sides) length += glm::length(to_mm(b) - to_mm(a));
  const double spacing = std::max(point_spacing_mm, length / most_points);
  std::vector<LatticePoint> points;
  for (const auto& [a, b] : sides) {
    const vec2 way = to_mm(b) - to_mm(a);
    const double steps = std::ceil(glm::length(way) / spacing);
    for (double i = 0.0; i <= steps; i += 1.0) points.push_back(to_lattice(to_mm(a) + i / steps * way));
  }
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<SitePoint> sites;
  sites.reserve(points.size());
  for (const LatticePoint p : points) sites.push_back(frame.site(p));
  return sites;
}

}  // namespace

Circle inscribed_circle(const Region& region) {
  const RegionIndex border(region);
  const SiteFrame frame(border.box());
  const std::vector<Piece> sides = parted_sides(border);
  Diagram diagram;
  if (some_cross(border)) {
    const auto sites = points_along(sides, frame);
    boost::polygon::construct_voronoi(sites.begin(), sites.end(), &diagram);
  } else {
    std::vector<boost::polygon::segment_data<std::int32_t>> sites;
    sites.reserve(sides.size());
    for (const auto& [a, b] : sides) sites.emplace_back(frame.site(a), frame.site(b));
    boost::polygon::construct_voronoi(sites.begin(), sites.end(), &diagram);
  }
  const Box box = border.box();
  Circle largest;
  for (const Diagram::vertex_type& vertex : diagram.vertices()) {
    const vec2 middle = frame.place(vertex);
    const vec2 room = glm::min(middle - box.low, box.high - middle);
    if (std::min(room.x, room.y) <= largest.radius || border.border_within(middle, largest.radius)) continue;
    if (!border.contains(on_lattice(middle))) continue;
    largest = {middle, border.nearest(middle).distance_mm};
  }
  return largest;
}

}  // namespace shatterpave::geometry
