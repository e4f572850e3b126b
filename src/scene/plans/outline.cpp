#include "scene/plans/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
  std::optional<std::size_t> spike;  // the number of the given point at the tip of one that was left out
};

// Shorter ones are of rounding.
constexpr std::int64_t shortest_told_spike = 10;  // µm

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

// Whether the line doubles back at b, which is redundant.
bool is_spike(const CleanVertex& a, const CleanVertex& b, const CleanVertex& c) {
  const auto far = [&](const LatticePoint& p) {
    return std::max(std::abs(p.x - b.at.x), std::abs(p.y - b.at.y)) >= shortest_told_spike;
  };
  return far(a.at) && far(c.at) && !geometry::on_segment(a.at, c.at, b.at);
}

// Appends a vertex after those that it makes redundant are gone.
void append(const CleanVertex& vertex, std::vector<CleanVertex>& kept, std::optional<std::size_t>& spike) {
  while (!kept.empty()) {
    // Of repeated points the last one is where the edge starts.
    const bool repeats = kept.back().at == vertex.at;
    if (!repeats && (kept.size() < 2 || !redundant(kept[kept.size() - 2], kept.back(), vertex))) break;
    if (!repeats && !spike && is_spike(kept[kept.size() - 2], kept.back(), vertex)) spike = kept.back().given;
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
  CleanRing clean;
  for (std::size_t i = 0; i < ring.points_mm.size(); ++i) {
    append({geometry::to_lattice(limited(ring.points_mm[i], ring.place)), i}, kept, clean.spike);
  }
  close(kept);
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

struct FaultText {
  std::string expected;
  std::string got;
};

FaultText fault_text(const RegionFault& fault, const std::vector<CleanRing>& rings) {
  const auto edge = [&](const RingEdge& e) {
    return fmt::format("edge {} of {}", rings[e.ring].given[e.edge], ring_name(e.ring));
  };
  const std::string at = fmt::format("at ({}, {})", fault.at_mm.x, fault.at_mm.y);
  const std::string both = fmt::format("{} and {}", edge(fault.a), edge(fault.b));
  switch (fault.kind) {
    case RegionFault::Kind::crossing:
      return {"edges that do not cross", fmt::format("{} crossing {}", both, at)};
    case RegionFault::Kind::overlap:
      return {"edges that do not overlap", fmt::format("{} overlapping {}", both, at)};
    case RegionFault::Kind::touch:
      return {"a ring that does not touch itself", fmt::format("{} meeting {}", both, at)};
    case RegionFault::Kind::hole_outside:
      return {"holes inside the outline", fmt::format("{} outside {}", ring_name(fault.a.ring), at)};
    case RegionFault::Kind::holes_overlap:
      return {"holes that do not overlap", fmt::format("{} inside another {}", ring_name(fault.a.ring), at)};
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

// Whether `inner` lies inside `outer`, none of whose edges it crosses: its vertices decide, or if all are on the border, the
// middle of an edge that is not. Nothing if it passes through where both have a vertex.
std::optional<bool> lies_inside(const FilledRing& inner, const FilledRing& outer) {
  if (std::abs(inner.area_mm2) >= std::abs(outer.area_mm2) || !geometry::boxes_meet(inner.box, outer.box)) return false;
  const Polygon& points = inner.clean.points;
  std::optional<bool> inside;
  for (const vec2& vertex : points) {
    if (outer.index.border_within(vertex, 0.5 / geometry::lattice_per_mm)) continue;
    const bool vertex_inside = outer.index.contains(vertex);
    if (inside && *inside != vertex_inside) return std::nullopt;
    inside = vertex_inside;
  }
  for (std::size_t i = 0; i < points.size() && !inside; ++i) {
    const vec2 middle = geometry::on_lattice(0.5 * (points[i] + points[(i + 1) % points.size()]));
    if (!on_border(outer.clean.points, middle)) inside = outer.index.contains(middle);
  }
  return inside.value_or(false);
}

std::vector<Polygon> polygons_of(const std::vector<FilledRing>& rings) {
  std::vector<Polygon> polygons;
  polygons.reserve(rings.size());
  for (const FilledRing& ring : rings) polygons.push_back(ring.clean.points);
  return polygons;
}

// Whether rings cross, or have stretches of edges in common, or touch themselves. They may lie in one another.
bool rings_interfere(const std::vector<FilledRing>& rings) {
  // The test for regions, with an outline about all: which ring lies in which is not asked here.
  const double far = geometry::largest_coordinate_mm + 1.0;
  const auto fault = geometry::region_fault({{-far, -far}, {far, -far}, {far, far}, {-far, far}}, polygons_of(rings));
  return fault && fault->kind != RegionFault::Kind::holes_overlap;
}

using Containers = std::vector<std::vector<std::size_t>>;

// For each ring, those about it; nothing if rings pass through each other.
std::optional<Containers> containers_of(const std::vector<FilledRing>& rings) {
  if (rings_interfere(rings)) return std::nullopt;
  Containers containers(rings.size());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t j = 0; j < rings.size(); ++j) {
      if (i == j) continue;
      const auto inside = lies_inside(rings[i], rings[j]);
      if (!inside) return std::nullopt;
      if (*inside) containers[i].push_back(j);
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

// The regions of rings of which it is known which lies in which.
std::vector<Region> nested_regions(const std::vector<FilledRing>& rings, const Containers& containers, FillRule rule) {
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
  return regions;
}

// Calls fill(), which may find that rings cross too often.
template <typename Fill>
std::vector<Region> filled_at(const Place& place, Fill fill) {
  try {
    return fill();
  } catch (const geometry::TooManyCrossings&) {
    throw InputError(place, fmt::format("expected edges that cross at most {} times, got more", geometry::most_crossings));
  }
}

std::vector<Region> filled_anew(const std::vector<FilledRing>& rings, FillRule rule) {
  return filled_at(rings.front().given->place, [&] { return geometry::filled(polygons_of(rings), rule); });
}

// An outline and its holes: all rings in this order, and the points of the holes once more.
struct PolygonRings {
  std::vector<CleanRing> all;
  std::vector<Polygon> holes;
};

PolygonRings polygon_rings(const Ring& outline, const std::vector<Ring>& holes) {
  limit_rings(holes, outline.points_mm.size(), outline.place);
  PolygonRings rings{{clean_ring_with_area(outline)}, {}};
  for (const Ring& hole : holes) {
    rings.all.push_back(clean_ring_with_area(hole));
    rings.holes.push_back(rings.all.back().points);
  }
  return rings;
}

std::vector<Region> repaired(const PolygonRings& rings, const Place& place) {
  return filled_at(place,
                   [&] { return geometry::filled_without(rings.all[0].points, rings.holes, geometry::FillRule::evenodd); });
}

// Whether the regions have the area that the rings add up to, but for what the lattice rounds along them.
bool as_large_as(const PolygonRings& rings, const std::vector<Region>& regions) {
  double area = 0.0;
  double round = 0.0;
  for (std::size_t r = 0; r < rings.all.size(); ++r) {
    const Polygon& ring = rings.all[r].points;
    area += (r == 0 ? 1.0 : -1.0) * std::abs(geometry::area(ring));
    for (std::size_t i = 0; i < ring.size(); ++i) round += glm::distance(ring[i], ring[(i + 1) % ring.size()]);
  }
  double filled = 0.0;
  for (const Region& region : regions) filled += geometry::area(region);
  return std::abs(filled - area) <= round / geometry::lattice_per_mm;
}

// Whether each vertex of the rings is on the border of the region, but for what the lattice rounds: so no corner was cut off.
bool keeps_vertices(const PolygonRings& rings, const Region& region) {
  constexpr double rounded_mm = 2.0 / geometry::lattice_per_mm;
  const geometry::RegionIndex index(region);
  return std::ranges::all_of(rings.all, [&](const CleanRing& ring) {
    return std::ranges::all_of(ring.points, [&](vec2 vertex) { return index.border_within(vertex, rounded_mm); });
  });
}

const Place& fault_place(const RegionFault& fault, const Ring& outline, const std::vector<Ring>& holes) {
  const std::size_t ring = std::max(fault.a.ring, fault.b.ring);
  return ring == 0 ? outline.place : holes[ring - 1].place;
}

void tell_repair(const FaultText& text, const std::vector<Region>& regions, const Place& place, std::vector<Note>* notes) {
  if (notes == nullptr) return;
  double area_mm2 = 0.0;
  for (const Region& region : regions) area_mm2 += geometry::area(region);
  const std::string count = regions.size() == 1 ? "one area" : fmt::format("{} areas", regions.size());
  add_note({place, fmt::format("read as what the outline encloses (even-odd) and no hole does, {} of {:.6g} m², since {}",
                               count, area_mm2 * 1e-6, text.got)},
           *notes);
}

void tell_spike(const Ring& ring, std::size_t point, std::vector<Note>* notes) {
  if (notes == nullptr) return;
  const vec2 at = geometry::on_lattice(ring.points_mm[point]);
  add_note({ring.place, fmt::format("a spike without width is left out: point {} at ({}, {})", point, at.x, at.y)}, *notes);
}

// A hole that encloses nothing takes nothing away.
std::vector<Ring> holes_with_area(const std::vector<Ring>& holes, std::vector<Note>* notes) {
  std::vector<Ring> kept;
  for (const Ring& hole : holes) {
    if (has_area(hole)) {
      kept.push_back(hole);
    } else if (notes != nullptr) {
      add_note({hole.place, "a hole that encloses no area is left out"}, *notes);
    }
  }
  return kept;
}

}  // namespace

Region canonical(Region region) {
  region = geometry::oriented_region(std::move(region.outline), std::move(region.holes));
  start_at_leftmost(region.outline);
  for (Polygon& hole : region.holes) start_at_leftmost(hole);
  return region;
}

Region region_of(const Ring& outline, const std::vector<Ring>& holes, std::vector<Note>* notes) {
  const PolygonRings rings = polygon_rings(outline, holes);
  const auto fault = geometry::region_fault(rings.all[0].points, rings.holes);
  if (!fault) return canonical({rings.all[0].points, rings.holes});
  std::vector<Region> regions = repaired(rings, outline.place);
  const Place& place = fault_place(*fault, outline, holes);
  const FaultText text = fault_text(*fault, rings.all);
  if (regions.size() != 1 || !as_large_as(rings, regions) || !keeps_vertices(rings, regions.front())) {
    throw InputError(place, fmt::format("expected {}, got {}", text.expected, text.got));
  }
  tell_repair(text, regions, place, notes);
  return canonical(std::move(regions.front()));
}

std::vector<Region> regions_of_polygon(const Ring& outline, const std::vector<Ring>& given_holes, std::vector<Note>* notes) {
  const std::vector<Ring> holes = holes_with_area(given_holes, notes);
  const PolygonRings rings = polygon_rings(outline, holes);
  for (std::size_t i = 0; i < rings.all.size(); ++i) {
    if (rings.all[i].spike) tell_spike(i == 0 ? outline : holes[i - 1], *rings.all[i].spike, notes);
  }
  const auto fault = geometry::region_fault(rings.all[0].points, rings.holes);
  if (!fault) return {canonical({rings.all[0].points, rings.holes})};
  std::vector<Region> regions = repaired(rings, outline.place);
  if (regions.empty()) throw InputError(outline.place, "expected an outline with an area, got one that encloses none");
  tell_repair(fault_text(*fault, rings.all), regions, fault_place(*fault, outline, holes), notes);
  for (Region& region : regions) region = canonical(std::move(region));
  return regions;
}

std::vector<Region> drawn_regions(const std::vector<Ring>& given, FillRule rule) {
  if (given.empty()) return {};
  limit_rings(given, 0, given.front().place);
  const std::vector<FilledRing> rings = rings_with_area(given);
  if (rings.empty()) return {};
  const auto containers = containers_of(rings);
  std::vector<Region> regions = containers ? nested_regions(rings, *containers, rule) : filled_anew(rings, rule);
  for (Region& region : regions) region = canonical(std::move(region));
  return regions;
}

std::vector<Region> filled_regions(const std::vector<Ring>& rings, FillRule rule) {
  std::vector<Region> regions = drawn_regions(rings, rule);
  if (!regions.empty()) return regions;
  if (std::ranges::none_of(rings, has_area)) clean_ring_with_area(rings.front());  // says what is wrong with it
  throw InputError(rings.front().place, "expected subpaths that fill an area, got such that fill none");
}

bool has_area(const Ring& ring) { return clean_ring(ring).points.size() >= 3; }

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
