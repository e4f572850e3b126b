// What lies between the border and the flat parts is parted in strips, each of which is triangulated in the plane and lifted.
// Which surface a triangle is of follows from the side of the border from which it leads up, which it knows by its corners.
// What leads from border to border, as in a neck narrower than two bevels, would lie level below the face: there the bevels are
// made to meet in a ridge.
#include "glass/shards/shard_bevel.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "geometry/plane_mesh.h"
#include "geometry/segment_distance.h"
#include "geometry/triangulation.h"
#include "glass/map/crack_paths.h"
#include "glass/shards/shard_solid.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;
using geometry::PlaneMesh;
using geometry::Polygon;
using geometry::Region;
using LatticeRing = std::vector<LatticePoint>;

constexpr std::size_t unnumbered = static_cast<std::size_t>(-1);

// Ridges nearer to the border than this, and bevels thinner than this in plan, are not made: a few steps of the lattice.
constexpr std::int64_t least_ridge_um = 4;

// ---- strips

struct StripVertex {
  std::size_t number = 0;  // in the side
  std::int64_t rise_um = 0;
  std::size_t before = unnumbered;  // on the border: its neighbours in the strip
  std::size_t next = unnumbered;
  bool is_old = false;  // the side of the border to the next one
  bool on_ridge = false;

  bool on_border() const { return next != unnumbered; }
};

// What lies between rings of the blank and of the flat parts.
struct Strip {
  std::vector<LatticeRing> rings;
  std::vector<StripVertex> vertices;  // of all rings
};

// Numbers of the ring start at `first`.
void append_border(Strip& strip, const LatticeRing& ring, const std::vector<bool>& is_old, std::size_t first) {
  const std::size_t n = ring.size();
  const std::size_t here = strip.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    strip.vertices.push_back({first + i, 0, here + (i + n - 1) % n, here + (i + 1) % n, is_old[i]});
  }
  strip.rings.push_back(ring);
}

// A ring of a flat part, the other way round.
void append_turned(Strip& strip, const LatticeRing& ring, std::size_t first, std::int64_t rise_um) {
  for (std::size_t i = ring.size(); i-- > 0;) strip.vertices.push_back({first + i, rise_um});
  strip.rings.emplace_back(ring.rbegin(), ring.rend());
}

// Each hole of a flat part holds a strip, and so does the outline; other rings are holes of the innermost that holds them.
//   flat  the number of the flat parts' first vertex
std::vector<Strip> strips(const ShardBlank& blank, const std::vector<Region>& flats, std::size_t flat, std::int64_t rise_um) {
  std::vector<Strip> result(1);
  std::vector<const Polygon*> about{&blank.region.outline};
  struct Turned {
    const Polygon* outline;
    std::size_t first;
  };
  std::vector<Turned> outlines;
  for (const Region& region : flats) {
    const std::vector<LatticeRing> rings = geometry::lattice_rings(region);
    outlines.push_back({&region.outline, flat});
    flat += rings.front().size();
    for (std::size_t k = 1; k < rings.size(); ++k) {
      append_turned(result.emplace_back(), rings[k], flat, rise_um);
      about.push_back(&region.holes[k - 1]);
      flat += rings[k].size();
    }
  }
  const auto strip_with = [&](vec2 p) -> Strip& {
    std::size_t found = 0;
    for (std::size_t i = 1; i < about.size(); ++i) {
      if (!geometry::contains(*about[i], p)) continue;
      if (found == 0 || std::abs(geometry::area(*about[i])) < std::abs(geometry::area(*about[found]))) found = i;
    }
    return result[found];
  };
  const std::vector<LatticeRing> borders = geometry::lattice_rings(blank.region);
  std::size_t first = 0;
  for (std::size_t k = 0; k < borders.size(); ++k) {
    Strip& strip = k == 0 ? result.front() : strip_with(blank.region.holes[k - 1].front());
    append_border(strip, borders[k], blank.is_old[k], first);
    first += borders[k].size();
  }
  for (const Turned& turned : outlines) {
    append_turned(strip_with(turned.outline->front()), geometry::lattice_rings({*turned.outline, {}}).front(), turned.first,
                  rise_um);
  }
  return result;
}

// ---- ridges

// Edges within the mesh from border to border, each once.
std::vector<std::array<std::size_t, 2>> ties(const PlaneMesh& mesh, const std::vector<StripVertex>& vertices) {
  std::vector<std::array<std::size_t, 2>> result;
  for (const geometry::TriangleCorners& corners : mesh.triangles()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = corners[i];
      const std::size_t b = corners[(i + 1) % 3];
      if (a < b && vertices[a].on_border() && vertices[b].on_border() && mesh.triangle_at(b, a)) result.push_back({a, b});
    }
  }
  return result;
}

// The least height of a triangle in the plane.
double height_mm(const PlaneMesh& mesh, std::size_t a, std::size_t b, std::size_t c) {
  const vec2 p = geometry::to_mm(mesh.points()[a]);
  const vec2 q = geometry::to_mm(mesh.points()[b]);
  const vec2 r = geometry::to_mm(mesh.points()[c]);
  const double longest = std::max({glm::length(q - p), glm::length(r - q), glm::length(p - r)});
  return std::abs(cross(q - p, r - p)) / longest;
}

// Flips ties that part a triangle of border alone from one that reaches a flat part: both do so then.
void flip_ties(PlaneMesh& mesh, const std::vector<StripVertex>& vertices) {
  const double least_mm = geometry::to_mm(least_ridge_um);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : ties(mesh, vertices)) {
      const auto c = mesh.apex(a, b);
      const auto d = mesh.apex(b, a);
      if (!c || !d || vertices[*c].on_border() == vertices[*d].on_border()) continue;
      if (height_mm(mesh, a, *d, *c) < least_mm || height_mm(mesh, *d, b, *c) < least_mm) continue;
      changed = mesh.flip(a, b) || changed;
    }
  }
}

double distance_to_border_mm(const Strip& strip, LatticePoint point) {
  const vec2 p = geometry::to_mm(point);
  double least = 1e300;
  std::size_t here = 0;
  for (const LatticeRing& ring : strip.rings) {
    for (std::size_t i = 0; i < ring.size() && strip.vertices[here].on_border(); ++i) {
      least = std::min(
          least, geometry::distance_to_segment(p, geometry::to_mm(ring[i]), geometry::to_mm(ring[(i + 1) % ring.size()])));
    }
    here += ring.size();
  }
  return least;
}

// How high bevels from all sides about a point would meet there; nothing where the border is too near.
std::optional<std::int64_t> ridge_um(const Strip& strip, LatticePoint point, std::int64_t depth_um) {
  const std::int64_t away_um = geometry::to_lattice(distance_to_border_mm(strip, point));
  if (away_um < least_ridge_um) return std::nullopt;
  return std::min(depth_um, away_um);
}

// The vertex that the mesh has just got.
void append_ridge(Strip& strip, std::int64_t rise_um) {
  StripVertex& vertex = strip.vertices.emplace_back();
  vertex.number = unnumbered;
  vertex.rise_um = rise_um;
  vertex.on_ridge = true;
}

// Parts the ties that are left in their middles, and lifts these to the ridge.
void lift_ties(PlaneMesh& mesh, Strip& strip, std::int64_t depth_um) {
  for (const auto& [a, b] : ties(mesh, strip.vertices)) {
    const LatticePoint p = mesh.points()[a];
    const LatticePoint q = mesh.points()[b];
    const LatticePoint middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
    const auto rise_um = ridge_um(strip, middle, depth_um);
    if (rise_um && mesh.part(a, b, middle)) append_ridge(strip, *rise_um);
  }
}

// The middle of the circle that touches the three sides.
LatticePoint incentre(const PlaneMesh& mesh, const geometry::TriangleCorners& corners) {
  std::array<vec2, 3> p;
  std::ranges::transform(corners, p.begin(), [&](std::size_t v) { return geometry::to_mm(mesh.points()[v]); });
  const double a = glm::length(p[2] - p[1]);
  const double b = glm::length(p[0] - p[2]);
  const double c = glm::length(p[1] - p[0]);
  return geometry::to_lattice((a * p[0] + b * p[1] + c * p[2]) / (a + b + c));
}

// Lifts triangles of border alone in their middles: those whose ties run along the border.
void lift_triangles(PlaneMesh& mesh, Strip& strip, std::int64_t depth_um) {
  const std::size_t count = mesh.triangles().size();
  for (std::size_t t = 0; t < count; ++t) {
    const geometry::TriangleCorners corners = mesh.triangles()[t];
    if (!std::ranges::all_of(corners, [&](std::size_t v) { return strip.vertices[v].on_border(); })) continue;
    const LatticePoint middle = incentre(mesh, corners);
    const auto rise_um = ridge_um(strip, middle, depth_um);
    if (rise_um && mesh.part(t, middle)) append_ridge(strip, *rise_um);
  }
}

// ---- surfaces

ShardSurface surface_of(bool is_old) { return is_old ? ShardSurface::old : ShardSurface::broken; }

double side_mm(const PlaneMesh& mesh, std::size_t a, std::size_t b) {
  return glm::length(geometry::to_mm(mesh.points()[b]) - geometry::to_mm(mesh.points()[a]));
}

// How far a triangle leads in from its side a b, in the plane.
double reach_mm(const PlaneMesh& mesh, const geometry::TriangleCorners& corners, std::size_t a, std::size_t b) {
  std::array<vec2, 3> p;
  std::ranges::transform(corners, p.begin(), [&](std::size_t v) { return geometry::to_mm(mesh.points()[v]); });
  return cross(p[1] - p[0], p[2] - p[0]) / side_mm(mesh, a, b);
}

// Whether that is farther than a bevel leads, which is as wide as deep: then the triangle is of a chip, or of a tip that bevels
// of both its sides take.
bool reaches_in(const PlaneMesh& mesh, const geometry::TriangleCorners& corners, std::size_t a, std::size_t b,
                std::int64_t depth_um) {
  return reach_mm(mesh, corners, a, b) > 1.5 * geometry::to_mm(depth_um) + geometry::to_mm(least_ridge_um);
}

// Whether the side is a stub, shorter than the triangle leads in from it, as an acute corner leaves them: the triangle may run
// on along the side beside it.
bool is_stub(const PlaneMesh& mesh, const geometry::TriangleCorners& corners, std::size_t a, std::size_t b) {
  return side_mm(mesh, a, b) < reach_mm(mesh, corners, a, b);
}

// Of a triangle with a side of the border, where rounding may leave two: then a broken one wins.
std::optional<ShardSurface> surface_by_side(const PlaneMesh& mesh, const geometry::TriangleCorners& corners,
                                            const std::vector<StripVertex>& vertices, std::int64_t depth_um) {
  std::optional<ShardSurface> surface;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t a = corners[i];
    const std::size_t b = corners[(i + 1) % 3];
    if (vertices[a].next != b || surface == ShardSurface::broken || is_stub(mesh, corners, a, b)) continue;
    surface = surface_of(vertices[a].is_old && !reaches_in(mesh, corners, a, b, depth_um));
  }
  return surface;
}

// The sides of the border at a vertex, by the vertices from which they start: on either way up to the first that is not as
// short as rounding makes them.
void append_sides_at(std::size_t vertex, const PlaneMesh& mesh, const std::vector<StripVertex>& vertices,
                     std::vector<std::size_t>& sides) {
  const auto is_short = [&](std::size_t v) { return side_mm(mesh, v, vertices[v].next) < geometry::to_mm(2 * least_ridge_um); };
  for (std::size_t v = vertex;; v = vertices[v].next) {
    sides.push_back(v);
    if (!is_short(v) || vertices[v].next == vertex) break;
  }
  for (std::size_t v = vertices[vertex].before;; v = vertices[v].before) {
    sides.push_back(v);
    if (!is_short(v) || v == vertex) break;
  }
}

// The sides of the border at the triangle's corners.
std::vector<std::size_t> sides_at(const geometry::TriangleCorners& corners, const PlaneMesh& mesh,
                                  const std::vector<StripVertex>& vertices) {
  std::vector<std::size_t> sides;
  for (const std::size_t corner : corners) {
    if (vertices[corner].on_border()) append_sides_at(corner, mesh, vertices, sides);
  }
  return sides;
}

// That of the side of the border that is nearest to the middle of the triangle: of those at its corners, or of all where the
// triangle is at a ridge, or these are farther off than a bevel is wide.
ShardSurface surface_by_place(const PlaneMesh& mesh, const geometry::TriangleCorners& corners,
                              const std::vector<StripVertex>& vertices, std::int64_t depth_um, bool at_ridge) {
  const auto at = [&](std::size_t v) { return geometry::to_mm(mesh.points()[v]); };
  const vec2 middle = (at(corners[0]) + at(corners[1]) + at(corners[2])) / 3.0;
  double least_mm = 1e300;
  bool is_old = false;
  const auto look_at = [&](std::size_t v) {
    const double distance_mm = geometry::distance_to_segment(middle, at(v), at(vertices[v].next));
    if (distance_mm >= least_mm) return;
    least_mm = distance_mm;
    is_old = vertices[v].is_old;
  };
  if (!at_ridge) std::ranges::for_each(sides_at(corners, mesh, vertices), look_at);
  if (least_mm > geometry::to_mm(depth_um)) {
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (vertices[v].on_border()) look_at(v);
    }
  }
  return surface_of(is_old);
}

ShardSurface surface_of(const PlaneMesh& mesh, const geometry::TriangleCorners& corners,
                        const std::vector<StripVertex>& vertices, std::int64_t depth_um) {
  if (std::ranges::all_of(corners, [&](std::size_t c) { return vertices[c].rise_um == depth_um; })) return ShardSurface::old;
  const bool at_ridge = std::ranges::any_of(corners, [&](std::size_t c) { return vertices[c].on_ridge; });
  const auto by_side = surface_by_side(mesh, corners, vertices, depth_um);
  if (by_side && !at_ridge) return *by_side;
  return surface_by_place(mesh, corners, vertices, depth_um, at_ridge);
}

void append_strip(ShardSide& side, std::size_t border, Strip strip, std::int64_t depth_um) {
  PlaneMesh mesh(strip.rings);
  mesh.make_delaunay();
  flip_ties(mesh, strip.vertices);
  lift_ties(mesh, strip, depth_um);
  lift_triangles(mesh, strip, depth_um);
  for (std::size_t v = 0; v < strip.vertices.size(); ++v) {
    if (strip.vertices[v].number != unnumbered) continue;
    strip.vertices[v].number = border + side.vertices.size();
    side.vertices.push_back({mesh.points()[v], strip.vertices[v].rise_um});
  }
  for (const geometry::TriangleCorners& corners : mesh.triangles()) {
    ShardSide::Triangle triangle{{}, surface_of(mesh, corners, strip.vertices, depth_um)};
    std::ranges::transform(corners, triangle.corners.begin(), [&](std::size_t v) { return strip.vertices[v].number; });
    side.triangles.push_back(triangle);
  }
}

void append_flat(ShardSide& side, const Region& region, std::size_t first) {
  PlaneMesh mesh(geometry::lattice_rings(region));
  mesh.make_delaunay();
  for (const auto& [a, b, c] : mesh.triangles())
    side.triangles.push_back({{first + a, first + b, first + c}, ShardSurface::old});
}

}  // namespace

ShardSide sharp_side(const ShardBlank& blank) {
  ShardSide side;
  append_flat(side, blank.region, 0);
  return side;
}

ShardSide bevelled_side(const ShardBlank& blank, const std::vector<Region>& flats, std::int64_t depth_um) {
  std::size_t border = 0;
  for (const std::vector<bool>& ring : blank.is_old) border += ring.size();
  ShardSide side;
  std::vector<std::size_t> firsts;
  for (const Region& region : flats) {
    firsts.push_back(border + side.vertices.size());
    for (const LatticeRing& ring : geometry::lattice_rings(region)) {
      for (const LatticePoint p : ring) side.vertices.push_back({p, depth_um});
    }
  }
  for (Strip& strip : strips(blank, flats, border, depth_um)) append_strip(side, border, std::move(strip), depth_um);
  for (std::size_t i = 0; i < flats.size(); ++i) append_flat(side, flats[i], firsts[i]);
  return side;
}

}  // namespace shatterpave::glass
