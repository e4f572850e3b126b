// What lies nearest to a side is its cell in the Voronoi diagram of all sides, so that mitres halve the angles at corners. At a
// corner inwards what lies nearest to the corner itself goes with one of its two sides: there the rows meet in a butt joint.
#include "paving/field/border_zones.h"

#include <algorithm>
#include <array>
#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <map>

#include "core/disjoint_sets.h"
#include "geometry/clip.h"
#include "geometry/corners.h"
#include "geometry/lattice.h"

namespace shatterpave::paving {

namespace {

using Segment = geometry::RegionIndex::Segment;
using Diagram = boost::polygon::voronoi_diagram<double>;

// Rows that meet at less than this bend, at more they are mitred: sine of 50°. By eye: rows bend about an octagon, not about a
// hexagon.
constexpr double mitre_sine = 0.766;
// Rows that face each other are alike at less than this: sine of 20°. By eye: with more, rows about a hole are drawn out of
// round by one side of the outline.
constexpr double facing_sine = 0.342;
// Curved parts of a mitre (between a side and a corner inwards) are drawn by so many straight ones.
constexpr int curve_steps = 16;
// Smaller scraps between zones come of rounding.
constexpr double least_zone_mm2 = 0.01;

vec2 unit_along(const Segment& s) { return (s.to - s.from) / glm::length(s.to - s.from); }

double turn_sine(const Segment& a, const Segment& b) { return std::abs(cross(unit_along(a), unit_along(b))); }

// Each side with those that begin where it ends.
std::vector<std::pair<std::size_t, std::size_t>> corners_of(const std::vector<Segment>& sides) {
  std::multimap<geometry::LatticePoint, std::size_t> begins;
  for (std::size_t s = 0; s < sides.size(); ++s) begins.emplace(geometry::to_lattice(sides[s].from), s);
  std::vector<std::pair<std::size_t, std::size_t>> corners;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const auto [first, last] = begins.equal_range(geometry::to_lattice(sides[s].to));
    for (auto next = first; next != last; ++next) corners.emplace_back(s, next->second);
  }
  return corners;
}

// Runs of sides that bend gently, and short runs with the neighbour that they turn from the least.
DisjointSets runs_of(const std::vector<Segment>& sides, double least_run_mm) {
  auto corners = corners_of(sides);
  std::ranges::stable_sort(corners, {}, [&](const auto& c) { return turn_sine(sides[c.first], sides[c.second]); });
  DisjointSets runs(sides.size());
  for (const auto& [a, b] : corners) {
    if (turn_sine(sides[a], sides[b]) < mitre_sine) runs.join(a, b);
  }
  std::vector<double> length(sides.size(), 0.0);
  for (std::size_t s = 0; s < sides.size(); ++s) length[runs.of(s)] += glm::length(sides[s].to - sides[s].from);
  for (const auto& [a, b] : corners) {
    const std::size_t run_a = runs.of(a);
    const std::size_t run_b = runs.of(b);
    if (run_a == run_b || std::min(length[run_a], length[run_b]) >= least_run_mm) continue;
    const double together = length[run_a] + length[run_b];
    runs.join(a, b);
    length[runs.of(a)] = together;
  }
  return runs;
}

// The Voronoi diagram asks for sides that meet in their ends only.
bool meet_in_ends(const geometry::RegionIndex& border) {
  constexpr double touching_mm = 0.002;
  std::vector<std::size_t> near;
  return std::ranges::all_of(border.segments(), [&](const Segment& side) {
    near.clear();
    border.near(side.from, touching_mm, near);
    return std::ranges::all_of(
        near, [&](std::size_t n) { return border.segments()[n].from == side.from || border.segments()[n].to == side.from; });
  });
}

// The diagram of the sides, and of a box far about them, which makes their cells finite.
class SideCells {
 public:
  explicit SideCells(const geometry::RegionIndex& border) : border_(border) {
    std::vector<Site> sites;
    for (const Segment& s : border.segments()) sites.push_back(site(s.from, s.to));
    const geometry::Box box = border.box();
    const vec2 room = vec2{1000.0, 1000.0} + 0.25 * (box.high - box.low);
    const std::array about = geometry::corners({box.low - room, box.high + room});
    for (std::size_t i = 0; i < 4; ++i) sites.push_back(site(about[i], about[(i + 1) % 4]));
    boost::polygon::construct_voronoi(sites.begin(), sites.end(), &diagram_);
  }

  // Calls `visit(a, b, length)` for each straight border within the region between what is nearest to side a and to side b.
  template <typename Visit>
  void for_each_seam(Visit visit) const {
    for (const Diagram::edge_type& edge : diagram_.edges()) {
      const Diagram::edge_type& twin = *edge.twin();
      if (&twin < &edge || !edge.is_finite() || !edge.is_primary()) continue;
      if (!is_of_side(*edge.cell()) || !is_of_side(*twin.cell())) continue;
      const vec2 from = at(*edge.vertex0());
      const vec2 to = at(*edge.vertex1());
      if (border_.contains(0.5 * (from + to))) visit(side(*edge.cell()), side(*twin.cell()), glm::length(to - from));
    }
  }

  // Calls `visit(side, beyond, way)` for each edge of each cell, which is what lies nearest to `side`, to its left; beyond it
  // lies what is nearest to `beyond`, which may be no side. A corner goes with one of its sides.
  template <typename Visit>
  void for_each_edge(Visit visit) const {
    for (const Diagram::edge_type& edge : diagram_.edges()) {
      const std::size_t own = side(*edge.cell());
      if (own < border_.segments().size() && edge.is_finite()) visit(own, side(*edge.twin()->cell()), way(edge));
    }
  }

 private:
  using Point = boost::polygon::point_data<std::int32_t>;
  using Site = boost::polygon::segment_data<std::int32_t>;

  static Point point(vec2 p) {
    const auto on = geometry::to_lattice(p);
    return {static_cast<std::int32_t>(on.x), static_cast<std::int32_t>(on.y)};
  }
  static Site site(vec2 from, vec2 to) { return {point(from), point(to)}; }
  static vec2 at(const Diagram::vertex_type& v) { return vec2{v.x(), v.y()} / geometry::lattice_per_mm; }
  static std::size_t side(const Diagram::cell_type& cell) { return cell.source_index(); }
  bool is_of_side(const Diagram::cell_type& cell) const {
    return cell.contains_segment() && side(cell) < border_.segments().size();
  }

  // From the edge's first vertex to its last. The edge from the other side goes through the same points.
  std::vector<vec2> way(const Diagram::edge_type& edge) const {
    std::vector<vec2> points{geometry::on_lattice(at(*edge.vertex0()))};
    if (edge.is_curved()) {
      const bool turned = edge.twin() < &edge;
      std::vector<vec2> between = curve(turned ? *edge.twin() : edge);
      if (turned) std::ranges::reverse(between);
      points.insert(points.end(), between.begin(), between.end());
    }
    points.push_back(geometry::on_lattice(at(*edge.vertex1())));
    return points;
  }

  // Points between the ends of a parabola, which is as far from its focus as from the line of a side.
  std::vector<vec2> curve(const Diagram::edge_type& edge) const {
    const bool point_first = edge.cell()->contains_point();
    const Diagram::cell_type& of_point = point_first ? *edge.cell() : *edge.twin()->cell();
    const Diagram::cell_type& of_side = point_first ? *edge.twin()->cell() : *edge.cell();
    if (side(of_side) >= border_.segments().size() || side(of_point) >= border_.segments().size()) return {};
    const Segment& corner_side = border_.segments()[side(of_point)];
    const bool begins = of_point.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
    const Segment& line = border_.segments()[side(of_side)];
    const vec2 axis = unit_along(line);
    const vec2 d = (begins ? corner_side.from : corner_side.to) - line.from;
    const double focus = glm::dot(d, axis);
    const double height = cross(axis, d);
    if (std::abs(height) < 1.0 / geometry::lattice_per_mm) return {};
    const double first = glm::dot(at(*edge.vertex0()) - line.from, axis);
    const double last = glm::dot(at(*edge.vertex1()) - line.from, axis);
    std::vector<vec2> points;
    for (int step = 1; step < curve_steps; ++step) {
      const double x = first + (last - first) * step / curve_steps;
      const double y = ((x - focus) * (x - focus) + height * height) / (2.0 * height);
      points.push_back(geometry::on_lattice(line.from + x * axis + y * left_of(axis)));
    }
    return points;
  }

  const geometry::RegionIndex& border_;
  Diagram diagram_;
};

// The border between two runs, and how much of it has rows alike on both sides, mm.
struct Seam {
  std::pair<std::size_t, std::size_t> runs;
  double length = 0.0;
  double alike = 0.0;

  bool is_mitre() const { return alike <= 0.8 * length; }
};

// All seams between different sets, the longest first.
std::vector<Seam> seams_between(const SideCells& cells, const std::vector<Segment>& sides, const DisjointSets& runs) {
  std::map<std::pair<std::size_t, std::size_t>, Seam> found;
  cells.for_each_seam([&](std::size_t a, std::size_t b, double length) {
    const std::pair<std::size_t, std::size_t> beside = std::minmax({runs.of(a), runs.of(b)});
    if (beside.first == beside.second) return;
    Seam& seam = found[beside];
    seam.runs = beside;
    seam.length += length;
    if (turn_sine(sides[a], sides[b]) < facing_sine) seam.alike += length;
  });
  std::vector<Seam> seams;
  seams.reserve(found.size());
  for (const auto& [beside, seam] : found) seams.push_back(seam);
  std::ranges::stable_sort(seams, [](const Seam& a, const Seam& b) { return a.length > b.length; });
  return seams;
}

// Joins runs that face each other and have the same rows, unless a mitre would then lie within what was joined.
void join_facing(const SideCells& cells, const std::vector<Segment>& sides, DisjointSets& runs) {
  const std::vector<Seam> seams = seams_between(cells, sides, runs);
  for (const Seam& seam : seams) {
    const std::size_t a = runs.of(seam.runs.first);
    const std::size_t b = runs.of(seam.runs.second);
    const bool mitred = std::ranges::any_of(seams, [&](const Seam& other) {
      const std::size_t c = runs.of(other.runs.first);
      const std::size_t d = runs.of(other.runs.second);
      return other.is_mitre() && ((c == a && d == b) || (c == b && d == a));
    });
    if (!mitred) runs.join(a, b);
  }
}

// The lines about a zone, which lies to their left, chained to closed ones.
std::vector<geometry::Polygon> loops(const std::vector<std::pair<vec2, vec2>>& lines) {
  std::multimap<geometry::LatticePoint, std::size_t> begins;
  for (std::size_t l = 0; l < lines.size(); ++l) begins.emplace(geometry::to_lattice(lines[l].first), l);
  std::vector<geometry::Polygon> closed;
  while (!begins.empty()) {
    geometry::Polygon loop;
    for (auto next = begins.begin(); next != begins.end();) {
      loop.push_back(lines[next->second].first);
      const auto end = geometry::to_lattice(lines[next->second].second);
      begins.erase(next);
      next = begins.find(end);
    }
    loop = geometry::cleaned(loop);
    if (!loop.empty()) closed.push_back(std::move(loop));
  }
  return closed;
}

std::vector<geometry::Region> zone_areas(const std::vector<std::pair<vec2, vec2>>& lines, const geometry::Region& region) {
  std::vector<geometry::Polygon> outlines;
  std::vector<geometry::Polygon> holes;
  for (geometry::Polygon& loop : loops(lines)) (geometry::area(loop) > 0.0 ? outlines : holes).push_back(std::move(loop));
  std::vector<geometry::Region> areas;
  for (const geometry::Polygon& outline : outlines) {
    for (const geometry::Region& part : geometry::intersection(outline, region)) {
      for (geometry::Region& rest : geometry::difference(part, holes)) {
        if (geometry::area(rest) >= least_zone_mm2) areas.push_back(std::move(rest));
      }
    }
  }
  return areas;
}

}  // namespace

BorderZones border_zones(const geometry::Region& region, const geometry::RegionIndex& border, double least_run_mm) {
  const std::vector<Segment>& sides = border.segments();
  BorderZones one{std::vector<std::uint32_t>(sides.size(), 0), {{region}}};
  if (!meet_in_ends(border)) return one;
  DisjointSets runs = runs_of(sides, least_run_mm);
  const SideCells cells(border);
  join_facing(cells, sides, runs);

  BorderZones zones{std::vector<std::uint32_t>(sides.size(), 0), {}};
  std::map<std::size_t, std::uint32_t> numbers;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const auto next = static_cast<std::uint32_t>(numbers.size());
    zones.of_segment[s] = numbers.try_emplace(runs.of(s), next).first->second;
  }
  if (numbers.size() == 1) return one;
  std::vector<std::vector<std::pair<vec2, vec2>>> lines(numbers.size());
  cells.for_each_edge([&](std::size_t side, std::size_t beyond, const std::vector<vec2>& way) {
    const std::uint32_t zone = zones.of_segment[side];
    if (beyond < sides.size() && zones.of_segment[beyond] == zone) return;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      if (way[i] != way[i + 1]) lines[zone].emplace_back(way[i], way[i + 1]);
    }
  });
  for (const auto& about : lines) zones.areas.push_back(zone_areas(about, region));
  return zones;
}

}  // namespace shatterpave::paving
