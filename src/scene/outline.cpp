#include "scene/outline.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "geometry/lattice.h"
#include "geometry/simple.h"

namespace shatterpave::scene {

namespace {

using geometry::RegionFault;
using geometry::RingEdge;

// A ring without repeated points, and for each point its number among the given ones.
struct CleanRing {
  geometry::Polygon points;
  std::vector<std::size_t> given;
};

CleanRing clean_ring(const Ring& ring) {
  CleanRing clean;
  for (std::size_t i = 0; i < ring.points_mm.size(); ++i) {
    const vec2 p = ring.points_mm[i];
    const double limit = geometry::largest_coordinate_mm;
    if (!(std::abs(p.x) <= limit && std::abs(p.y) <= limit)) {
      throw InputError(ring.place, fmt::format("expected coordinates from {} to {} mm, got ({}, {})", -limit, limit, p.x, p.y));
    }
    const vec2 on_lattice = geometry::on_lattice(p);
    if (!clean.points.empty() && clean.points.back() == on_lattice) {
      clean.given.back() = i;  // the edge to the next point starts at the last of them
      continue;
    }
    clean.points.push_back(on_lattice);
    clean.given.push_back(i);
  }
  while (clean.points.size() > 1 && clean.points.front() == clean.points.back()) {
    clean.points.pop_back();
    clean.given.pop_back();
  }
  if (clean.points.size() < 3) {
    throw InputError(ring.place, fmt::format("expected 3 or more distinct points, got {}", clean.points.size()));
  }
  return clean;
}

std::string ring_name(std::size_t ring) { return ring == 0 ? "the outline" : fmt::format("hole {}", ring - 1); }

std::string fault_message(const RegionFault& fault, const std::vector<CleanRing>& rings) {
  const auto edge = [&](const RingEdge& e) {
    return fmt::format("edge {} of {}", rings[e.ring].given[e.edge], ring_name(e.ring));
  };
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
      return fmt::format("expected holes inside the outline, got {} outside {}", ring_name(fault.a.ring), at);
    case RegionFault::Kind::holes_overlap:
      return fmt::format("expected holes that do not overlap, got {} inside another {}", ring_name(fault.a.ring), at);
  }
  return {};
}

}  // namespace

geometry::Region region_of(const Ring& outline, const std::vector<Ring>& holes) {
  if (holes.size() > most_holes) {
    throw InputError(outline.place, fmt::format("expected at most {} holes, got {}", most_holes, holes.size()));
  }
  std::size_t count = outline.points_mm.size();
  for (const Ring& hole : holes) count += hole.points_mm.size();
  if (count > most_vertices) {
    throw InputError(outline.place, fmt::format("expected at most {} points, got {}", most_vertices, count));
  }
  std::vector<CleanRing> rings{clean_ring(outline)};
  std::vector<geometry::Polygon> hole_points;
  for (const Ring& hole : holes) {
    rings.push_back(clean_ring(hole));
    hole_points.push_back(rings.back().points);
  }
  if (const auto fault = geometry::region_fault(rings[0].points, hole_points)) {
    const std::size_t ring = std::max(fault->a.ring, fault->b.ring);
    throw InputError(ring == 0 ? outline.place : holes[ring - 1].place, fault_message(*fault, rings));
  }
  return geometry::oriented_region(std::move(rings[0].points), std::move(hole_points));
}

}  // namespace shatterpave::scene
