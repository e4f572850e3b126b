#include "scene/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <string>

#include "geometry/lattice.h"
#include "geometry/predicates.h"
#include "geometry/region_index.h"
#include "geometry/simple.h"

namespace shatterpave::scene {

namespace {

using geometry::LatticePoint;
using geometry::Polygon;
using geometry::Region;
using geometry::RegionFault;
using geometry::RingEdge;

// A vertex of a ring, and the number of the given point where its edge starts.
struct CleanVertex {
  LatticePoint at;
  std::size_t given = 0;
};

// A ring without points that add nothing.
struct CleanRing {
  Polygon points;
  std::vector<std::size_t> given;
};

vec2 limited(vec2 p, const Place& place) {
  const double limit = geometry::largest_coordinate_mm;
  if (!(std::abs(p.x) <= limit && std::abs(p.y) <= limit)) {
    throw InputError(place, fmt::format("expected coordinates from {} to {} mm, got ({}, {})", -limit, limit, p.x, p.y));
  }
  return p;
}

// Whether b adds nothing between a and c: it repeats one of them, or all three lie on a line (spikes too).
bool redundant(const CleanVertex& a, const CleanVertex& b, const CleanVertex& c) {
  return geometry::side(a.at, b.at, c.at) == geometry::Side::on;
}

// Appends a vertex after those that it makes redundant are gone.
void append(const CleanVertex& vertex, std::vector<CleanVertex>& kept) {
  while (!kept.empty()) {
    // Of repeated points the last one is where the edge starts.
    const bool repeats = kept.back().at == vertex.at;
    if (!repeats && (kept.size() < 2 || !redundant(kept[kept.size() - 2], kept.back(), vertex))) break;
    kept.pop_back();
  }
  kept.push_back(vertex);
}

// The same rule round the end of the ring.
void close(std::vector<CleanVertex>& kept) {
  std::size_t begin = 0;
  while (kept.size() - begin >= 2) {
    if (kept.back().at == kept[begin].at || redundant(kept[kept.size() - 2], kept.back(), kept[begin])) {
      kept.pop_back();
    } else if (redundant(kept.back(), kept[begin], kept[begin + 1])) {
      ++begin;
    } else {
      break;
    }
  }
  kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(begin));
}

// Of fewer than three vertices if the ring has no area.
CleanRing clean_ring(const Ring& ring) {
  std::vector<CleanVertex> kept;
  for (std::size_t i = 0; i < ring.points_mm.size(); ++i) {
    append({geometry::to_lattice(limited(ring.points_mm[i], ring.place)), i}, kept);
  }
  close(kept);
  CleanRing clean;
  for (const CleanVertex& vertex : kept) {
    clean.points.push_back(geometry::to_mm(vertex.at));
    clean.given.push_back(vertex.given);
  }
  return clean;
}

std::size_t distinct_points(const Ring& ring) {
  std::vector<LatticePoint> points;
  for (const vec2& p : ring.points_mm) points.push_back(geometry::to_lattice(p));
  std::ranges::sort(points);
  return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
}

CleanRing clean_ring_with_area(const Ring& ring) {
  CleanRing clean = clean_ring(ring);
  if (clean.points.size() >= 3) return clean;
  const std::size_t distinct = distinct_points(ring);
  if (distinct < 3) throw InputError(ring.place, fmt::format("expected 3 or more distinct points, got {}", distinct));
  throw InputError(ring.place, fmt::format("expected a ring with an area, got {} points that enclose none", distinct));
}

std::string ring_name(std::size_t ring) { return ring == 0 ? "the outline" : fmt::format("hole {}", ring - 1); }

using RingName = std::function<std::string(std::size_t)>;

std::string fault_message(const RegionFault& fault, const std::vector<CleanRing>& rings, const RingName& name) {
  const auto edge = [&](const RingEdge& e) { return fmt::format("edge {} of {}", rings[e.ring].given[e.edge], name(e.ring)); };
  const std::string at = fmt::format("at ({}, {})", fault.at_mm.x, fault.at_mm.y);
  const std::string both = fmt::format("{} and {}", edge(fault.a), edge(fault.b));
  switch (fault.kind) {
    case RegionFault::Kind::crossing:
      return fmt::format("expected edges that do not cross, got {} crossing {}", both, at);
    case RegionFault::Kind::overlap:
      return fmt::format("expected edges that do not overlap, got {} overlapping {}", both, at);
    case RegionFault::Kind::touch:
      return fmt::format("expected a ring that does not touch itself, got {} meeting {}", both, at);
    case RegionFault::Kind::hole_outside:
      return fmt::format("expected holes inside the outline, got {} outside {}", name(fault.a.ring), at);
    case RegionFault::Kind::holes_overlap:
      return fmt::format("expected holes that do not overlap, got {} inside another {}", name(fault.a.ring), at);
  }
  return {};
}

void limit_rings(const std::vector<Ring>& rings, std::size_t more_points, const Place& place) {
  if (rings.size() > most_holes) {
    throw InputError(place, fmt::format("expected at most {} holes, got {}", most_holes, rings.size()));
  }
  std::size_t count = more_points;
  for (const Ring& ring : rings) count += ring.points_mm.size();
  if (count > most_vertices) {
    throw InputError(place, fmt::format("expected at most {} points, got {}", most_vertices, count));
  }
}

// A ring of several that fill an area together.
struct FilledRing {
  const Ring* given = nullptr;
  CleanRing clean;
  double area_mm2 = 0.0;  // signed
  geometry::Box box;
  geometry::RegionIndex index;
};

bool on_border(const Polygon& ring, vec2 point) {
  const LatticePoint p = geometry::to_lattice(point);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (geometry::on_segment(geometry::to_lattice(ring[i]), geometry::to_lattice(ring[(i + 1) % ring.size()]), p)) return true;
  }
  return false;
}

[[noreturn]] void refuse_passing(const FilledRing& ring, vec2 at) {
  throw InputError(
      ring.given->place,
      fmt::format("expected rings that do not cross, got one that passes through another near ({}, {})", at.x, at.y));
}

// Whether `inner` lies inside `outer`, none of whose edges it crosses: its vertices decide, or if all are on the border, the
// middle of an edge that is not.
bool lies_inside(const FilledRing& inner, const FilledRing& outer) {
  if (std::abs(inner.area_mm2) >= std::abs(outer.area_mm2) || !geometry::boxes_meet(inner.box, outer.box)) return false;
  const Polygon& points = inner.clean.points;
  std::optional<bool> inside;
  for (const vec2& vertex : points) {
    if (outer.index.border_within(vertex, 0.5 / geometry::lattice_per_mm)) continue;
    const bool vertex_inside = outer.index.contains(vertex);
    // Rings can pass through each other where both have a vertex.
    if (inside && *inside != vertex_inside) refuse_passing(inner, vertex);
    inside = vertex_inside;
  }
  for (std::size_t i = 0; i < points.size() && !inside; ++i) {
    const vec2 middle = geometry::on_lattice(0.5 * (points[i] + points[(i + 1) % points.size()]));
    if (!on_border(outer.clean.points, middle)) inside = outer.index.contains(middle);
  }
  return inside.value_or(false);
}

// Rings may lie in one another, but they may neither cross nor have stretches of edges in common.
void refuse_crossing_rings(const std::vector<FilledRing>& rings) {
  // The test for regions, with an outline about all: which ring lies in which is not asked here.
  const double far = geometry::largest_coordinate_mm + 1.0;
  std::vector<CleanRing> clean{{{{-far, -far}, {far, -far}, {far, far}, {-far, far}}, {0, 1, 2, 3}}};
  std::vector<Polygon> holes;
  for (const FilledRing& ring : rings) {
    clean.push_back(ring.clean);
    holes.push_back(ring.clean.points);
  }
  const auto fault = geometry::region_fault(clean.front().points, holes);
  if (!fault || fault->kind == RegionFault::Kind::holes_overlap) return;
  const auto name = [&](std::size_t ring) { return rings.size() == 1 ? ring_name(0) : fmt::format("subpath {}", ring - 1); };
  const std::size_t ring = std::max(fault->a.ring, fault->b.ring);
  throw InputError(rings[ring - 1].given->place, fault_message(*fault, clean, name));
}

// For each ring, those about it.
std::vector<std::vector<std::size_t>> containers_of(const std::vector<FilledRing>& rings) {
  std::vector<std::vector<std::size_t>> containers(rings.size());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t j = 0; j < rings.size(); ++j) {
      if (i != j && lies_inside(rings[i], rings[j])) containers[i].push_back(j);
    }
  }
  return containers;
}

std::vector<FilledRing> rings_with_area(const std::vector<Ring>& given) {
  std::vector<FilledRing> rings;
  for (const Ring& ring : given) {
    CleanRing clean = clean_ring(ring);
    if (clean.points.size() < 3) continue;
    const double area = geometry::area(clean.points);
    const geometry::Box box = geometry::bounding_box(clean.points);
    geometry::RegionIndex index(geometry::oriented_region(clean.points, {}));
    rings.push_back({&ring, std::move(clean), area, box, std::move(index)});
  }
  return rings;
}

// What lies on the two sides of a ring.
struct Sides {
  bool filled_outside = false;
  bool filled_inside = false;
};

Sides sides_of(std::size_t ring, const std::vector<FilledRing>& rings, const std::vector<std::size_t>& containers,
               FillRule rule) {
  const auto turn = [&](std::size_t i) { return rings[i].area_mm2 > 0.0 ? 1 : -1; };
  const auto filled = [&](int winding) { return rule == FillRule::nonzero ? winding != 0 : winding % 2 != 0; };
  int outside = 0;
  for (const std::size_t container : containers) outside += turn(container);
  return {filled(outside), filled(outside + turn(ring))};
}

void start_at_leftmost(Polygon& ring) {
  const auto leftmost =
      std::ranges::min_element(ring, [](vec2 a, vec2 b) { return geometry::to_lattice(a) < geometry::to_lattice(b); });
  std::rotate(ring.begin(), leftmost, ring.end());
}

}  // namespace

Region canonical(Region region) {
  region = geometry::oriented_region(std::move(region.outline), std::move(region.holes));
  start_at_leftmost(region.outline);
  for (Polygon& hole : region.holes) start_at_leftmost(hole);
  return region;
}

Region region_of(const Ring& outline, const std::vector<Ring>& holes) {
  limit_rings(holes, outline.points_mm.size(), outline.place);
  std::vector<CleanRing> rings{clean_ring_with_area(outline)};
  std::vector<Polygon> hole_points;
  for (const Ring& hole : holes) {
    rings.push_back(clean_ring_with_area(hole));
    hole_points.push_back(rings.back().points);
  }
  if (const auto fault = geometry::region_fault(rings[0].points, hole_points)) {
    const std::size_t ring = std::max(fault->a.ring, fault->b.ring);
    throw InputError(ring == 0 ? outline.place : holes[ring - 1].place, fault_message(*fault, rings, ring_name));
  }
  return canonical({std::move(rings[0].points), std::move(hole_points)});
}

std::vector<Region> filled_regions(const std::vector<Ring>& given, FillRule rule) {
  limit_rings(given, 0, given.front().place);
  const std::vector<FilledRing> rings = rings_with_area(given);
  if (rings.empty()) {
    clean_ring_with_area(given.front());  // says what is wrong with it
    return {};
  }
  refuse_crossing_rings(rings);
  const auto containers = containers_of(rings);
  std::vector<std::optional<std::size_t>> region_at(rings.size());
  std::vector<std::size_t> holes;
  std::vector<Region> regions;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const Sides sides = sides_of(i, rings, containers[i], rule);
    if (sides.filled_outside == sides.filled_inside) continue;
    if (sides.filled_outside) {
      holes.push_back(i);
      continue;
    }
    region_at[i] = regions.size();
    regions.push_back({rings[i].clean.points, {}});
  }
  for (const std::size_t hole : holes) {
    // The smallest outline about it.
    std::optional<std::size_t> owner;
    for (const std::size_t container : containers[hole]) {
      if (!region_at[container]) continue;
      if (!owner || std::abs(rings[container].area_mm2) < std::abs(rings[*owner].area_mm2)) owner = container;
    }
    if (owner) regions[*region_at[*owner]].holes.push_back(rings[hole].clean.points);
  }
  for (Region& region : regions) region = canonical(std::move(region));
  return regions;
}

std::vector<vec2> line_of(const Ring& line) {
  std::vector<vec2> points;
  for (const vec2& given : line.points_mm) {
    const vec2 p = geometry::on_lattice(limited(given, line.place));
    if (points.empty() || points.back() != p) points.push_back(p);
  }
  if (points.size() < 2) {
    throw InputError(line.place, fmt::format("expected 2 or more distinct points, got {}", points.size()));
  }
  return points;
}

}  // namespace shatterpave::scene
