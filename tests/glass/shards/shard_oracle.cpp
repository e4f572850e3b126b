#include "glass/shards/shard_oracle.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "geometry/lattice.h"
#include "geometry/segment_distance.h"
#include "glass/map/crack_paths.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint3;
using geometry::SolidTriangle;

// Ends of cracks lie beside slanting edges by 1 µm, and cutting rounds once more.
constexpr double on_outline_mm = 0.003;
constexpr double narrow_mm = 0.008;
// Cosine of 30° from level.
constexpr double chip_slope = 0.87;

struct OutlineSide {
  vec2 a{0.0, 0.0};
  vec2 b{0.0, 0.0};
  bool is_old = false;
};

bool on_outline(const Pane& pane, vec2 p) {
  const std::size_t n = pane.outline_mm.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (geometry::distance_to_segment(p, pane.outline_mm[i], pane.outline_mm[(i + 1) % n]) <= on_outline_mm) return true;
  }
  return false;
}

// All the way, also where corners of the outline are as flat as that.
bool on_outline(const Pane& pane, vec2 a, vec2 b) {
  constexpr int steps = 8;
  for (int i = 0; i <= steps; ++i) {
    if (!on_outline(pane, glm::mix(a, b, static_cast<double>(i) / steps))) return false;
  }
  return true;
}

std::vector<OutlineSide> sides_of(const Pane& pane, const Shard& shard) {
  std::vector<OutlineSide> sides;
  const auto add = [&](const geometry::Polygon& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const vec2 b = ring[(i + 1) % ring.size()];
      sides.push_back({ring[i], b, on_outline(pane, ring[i], b)});
    }
  };
  add(shard.face.outline);
  std::ranges::for_each(shard.face.holes, add);
  return sides;
}

struct Facet {
  std::array<LatticePoint3, 3> corners;
  std::array<vec2, 3> plan;
  vec3 across{0.0, 0.0, 0.0};  // µm²: the normal, as long as twice the area

  double longest_um() const {
    double longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const LatticePoint3& p = corners[i];
      const LatticePoint3& q = corners[(i + 1) % 3];
      const vec3 d{static_cast<double>(q.x - p.x), static_cast<double>(q.y - p.y), static_cast<double>(q.z - p.z)};
      longest = std::max(longest, glm::length(d));
    }
    return longest;
  }
  bool is_level_at(std::int64_t z) const {
    return std::ranges::all_of(corners, [&](const LatticePoint3& p) { return p.z == z; });
  }
};

Facet facet_of(const Shard& shard, const SolidTriangle& triangle) {
  Facet facet;
  for (std::size_t i = 0; i < 3; ++i) {
    facet.corners[i] = shard.solid.vertices[triangle.corners[i]];
    facet.plan[i] = {geometry::to_mm(facet.corners[i].x), geometry::to_mm(facet.corners[i].y)};
  }
  const auto [a, b, c] = facet.corners;
  __extension__ using Product = __int128;
  const auto minor = [](Product p, Product q, Product r, Product s) { return static_cast<double>(p * s - q * r); };
  facet.across = {minor(b.y - a.y, b.z - a.z, c.y - a.y, c.z - a.z), minor(b.z - a.z, b.x - a.x, c.z - a.z, c.x - a.x),
                  minor(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y)};
  return facet;
}

// Where sides of one kind only are near: whether they are the old ones. 0: of both kinds; 1: broken; 2: old.
int nearest_kind(const std::vector<OutlineSide>& sides, const Facet& facet) {
  double old_mm = 1e300;
  double broken_mm = 1e300;
  int kind = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const vec2 p = (4.0 * facet.plan[k] + facet.plan[(k + 1) % 3] + facet.plan[(k + 2) % 3]) / 6.0;
    old_mm = broken_mm = 1e300;
    for (const OutlineSide& side : sides) {
      double& least = side.is_old ? old_mm : broken_mm;
      least = std::min(least, geometry::distance_to_segment(p, side.a, side.b));
    }
    const int here = old_mm + narrow_mm < 0.7 * broken_mm ? 2 : (broken_mm + narrow_mm < 0.7 * old_mm ? 1 : 0);
    if (kind >= 0 && kind != here) return 0;
    kind = here;
  }
  return kind;
}

class Inspection {
 public:
  Inspection(const Pane& pane, const Shard& shard) : pane_(pane), shard_(shard), sides_(sides_of(pane, shard)) {
    found_.shards = 1;
  }

  ShardFindings done() {
    for (const SolidTriangle& triangle : shard_.solid.triangles) look_at(triangle);
    look_at_edges();
    const std::int64_t top = geometry::to_lattice(pane_.thickness_mm);
    for (const LatticePoint3& p : shard_.solid.vertices) {
      if (p.z < 0 || p.z > top) fault("a vertex is outside of the pane", facet_of(shard_, shard_.solid.triangles.front()));
    }
    return std::move(found_);
  }

 private:
  void fault(const char* what, const Facet& facet) {
    const LatticePoint3& p = facet.corners[0];
    found_.faults.push_back(fmt::format("{}: {} at ({}, {}, {}) um, {:.0f} um long, {:.0f} um² large", shard_.id, what, p.x,
                                        p.y, p.z, facet.longest_um(), 0.5 * glm::length(facet.across)));
  }

  void look_at(const SolidTriangle& triangle) {
    ++found_.triangles;
    const Facet facet = facet_of(shard_, triangle);
    const double doubled_area = glm::length(facet.across);
    if (doubled_area == 0.0) return fault("a triangle without area", facet);
    const double height_um = doubled_area / facet.longest_um();
    found_.least_height_um = std::min(found_.least_height_um, height_um);
    if (height_um < 0.5) ++found_.thin;
    const bool is_old = triangle.slot == static_cast<int>(ShardSurface::old);
    const std::int64_t top = geometry::to_lattice(pane_.thickness_mm);
    if (facet.is_level_at(top) || facet.is_level_at(0)) {
      ++found_.faces;
      if (!is_old) fault("a part of a face is not old", facet);
      if ((facet.across.z > 0.0) != facet.is_level_at(top)) fault("a part of a face is turned over", facet);
    } else if (facet.across.z == 0.0) {
      look_at_wall(facet, is_old);
    } else {
      look_at_bevel(facet, is_old);
    }
  }

  // Upright: its corners have two places in the plane.
  void look_at_wall(const Facet& facet, bool is_old) {
    const vec2 a = facet.plan[0];
    const vec2 b = facet.plan[1] != a ? facet.plan[1] : facet.plan[2];
    const bool outline = on_outline(pane_, a, b);
    if (outline && glm::length(b - a) < narrow_mm) {
      ++found_.narrow;
    } else if (outline != is_old) {
      fault(outline ? "the edge of the pane is broken" : "the wall of a crack is old", facet);
    } else {
      ++(outline ? found_.edges : found_.walls);
    }
  }

  void look_at_bevel(const Facet& facet, bool is_old) {
    const bool front = 2 * facet.corners[0].z > geometry::to_lattice(pane_.thickness_mm);
    if ((facet.across.z > 0.0) != front) fault("a bevel is turned over", facet);
    const bool is_narrow = std::abs(facet.across.z) / facet.longest_um() < 1000.0 * narrow_mm;
    if (facet.across.x == 0.0 && facet.across.y == 0.0 && !is_narrow) {
      found_.level_bevel_mm2 += 0.5e-6 * std::abs(facet.across.z);
    }
    const int kind = nearest_kind(sides_, facet);
    // Shallower than a bevel is a chip, which may reach over the edge of the pane.
    const bool is_chip = std::abs(facet.across.z) > chip_slope * glm::length(facet.across);
    if (kind == 0 || (kind == 2 && is_chip)) {
      ++found_.undecided;
    } else if ((kind == 2) == is_old) {
      ++found_.bevels;
    } else if (is_narrow) {
      ++found_.narrow;
    } else {
      fault(kind == 2 ? "a bevel of the pane's edge is broken" : "a bevel of a crack is old", facet);
    }
  }

  void look_at_edges() {
    std::map<LatticePoint3, int> places;
    std::vector<int> place;
    for (const LatticePoint3& p : shard_.solid.vertices) {
      place.push_back(places.try_emplace(p, static_cast<int>(places.size())).first->second);
    }
    std::map<std::pair<int, int>, int> edges;
    for (const SolidTriangle& triangle : shard_.solid.triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++edges[{place[triangle.corners[i]], place[triangle.corners[(i + 1) % 3]]}];
    }
    for (const auto& [edge, times] : edges) {
      const auto reverse = edges.find({edge.second, edge.first});
      if (times == 1 && reverse != edges.end() && reverse->second == 1) continue;
      return fault("an edge without its one reverse", facet_of(shard_, shard_.solid.triangles.front()));
    }
  }

  const Pane& pane_;
  const Shard& shard_;
  std::vector<OutlineSide> sides_;
  ShardFindings found_;
};

}  // namespace

void ShardFindings::add(const ShardFindings& other) {
  shards += other.shards;
  triangles += other.triangles;
  faces += other.faces;
  edges += other.edges;
  walls += other.walls;
  bevels += other.bevels;
  undecided += other.undecided;
  narrow += other.narrow;
  thin += other.thin;
  least_height_um = std::min(least_height_um, other.least_height_um);
  level_bevel_mm2 += other.level_bevel_mm2;
  faults.insert(faults.end(), other.faults.begin(), other.faults.end());
}

ShardFindings findings(const Pane& pane, const Shard& shard) { return Inspection(pane, shard).done(); }

ShardFindings findings(const Pane& pane, const std::vector<Shard>& shards) {
  ShardFindings all;
  for (const Shard& shard : shards) all.add(findings(pane, shard));
  return all;
}

double flat_share(const Pane& pane, const Shard& shard) {
  const std::int64_t top = geometry::to_lattice(pane.thickness_mm);
  double flat_mm2 = 0.0;
  for (const SolidTriangle& triangle : shard.solid.triangles) {
    const Facet facet = facet_of(shard, triangle);
    const bool is_face = facet.is_level_at(top) || facet.is_level_at(0);
    if (is_face && triangle.slot == static_cast<int>(ShardSurface::old)) flat_mm2 += 0.5e-6 * std::abs(facet.across.z);
  }
  return flat_mm2 / (2.0 * geometry::area(shard.face));
}

}  // namespace shatterpave::glass
