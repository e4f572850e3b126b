// Between a sharp face and the upper end of the walls lies a bevel: the ring between the outline and a smaller face inside it,
// parted into triangles in the plane and lifted, each vertex to the height of the ring that it is of. So it closes whatever the
// two look like. Chips are bites off the smaller face, which make the bevel wide there. Where there are holes, the bevel is as
// many strips as there is room between the rings of the one and of the other.
#include "glass/shard_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "geometry/clip.h"
#include "geometry/contacts.h"
#include "geometry/simple.h"
#include "geometry/triangulation.h"
#include "glass/shards.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;
using geometry::Polygon;
using geometry::Region;
using geometry::Solid;
using LatticeRing = std::vector<LatticePoint>;

constexpr int old_slot = static_cast<int>(ShardSurface::old);
constexpr int broken_slot = static_cast<int>(ShardSurface::broken);

// A bevel takes at most this part of the thickness on either side.
constexpr double most_bevel = 0.3;
// A bite about `at`, its long axis along the unit vector `along`: an octagon, each corner drawn in and out.
Polygon bite(vec2 at, vec2 along, double half_mm, double reach_mm, std::uint64_t seed, Address address) {
  constexpr double diagonal = 0.70710678118654752;
  constexpr std::array<vec2, 8> corners = {
      vec2{1.0, 0.0},  vec2{diagonal, diagonal},   vec2{0.0, 1.0},  vec2{-diagonal, diagonal},
      vec2{-1.0, 0.0}, vec2{-diagonal, -diagonal}, vec2{0.0, -1.0}, vec2{diagonal, -diagonal}};
  Polygon polygon;
  for (const vec2 corner : corners) {
    const double size = 0.7 + 0.6 * uniform(seed, address);
    ++address.draw;
    polygon.push_back(geometry::on_lattice(at + size * (corner.x * half_mm * along + corner.y * reach_mm * left_of(along))));
  }
  return polygon;
}

struct BrokenSide {
  vec2 a;
  vec2 b;
  double end_mm = 0.0;  // length of all broken sides up to here
};

std::vector<BrokenSide> broken_sides(const ShardBlank& blank) {
  std::vector<BrokenSide> sides;
  double length_mm = 0.0;
  const std::vector<Polygon> rings = geometry::rings_of({blank.region});
  for (std::size_t k = 0; k < rings.size(); ++k) {
    const Polygon& ring = rings[k];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (blank.is_old[k][i]) continue;
      const vec2 b = ring[(i + 1) % ring.size()];
      length_mm += glm::length(b - ring[i]);
      sides.push_back({ring[i], b, length_mm});
    }
  }
  return sides;
}

// Chips off the broken edges of one face of the shard.
std::vector<Chip> chips_of(const ShardBlank& blank, const ShardRules& rules, Id face, std::uint64_t seed) {
  const std::vector<BrokenSide> sides = broken_sides(blank);
  std::vector<Chip> result;
  if (sides.empty() || rules.chip_mm <= 0.0) return result;
  const double length_mm = sides.back().end_mm;
  const int count = poisson(seed, {Stream::shard_chip, face}, std::min(1000.0, rules.chips_per_m * length_mm / 1000.0));
  for (int i = 0; i < count; ++i) {
    Address address{Stream::shard_chip, face.child(static_cast<std::uint64_t>(i))};
    const auto draw = [&] {
      const double value = uniform(seed, address);
      ++address.draw;
      return value;
    };
    const double at_mm = length_mm * draw();
    const auto side = std::ranges::upper_bound(sides, at_mm, {}, &BrokenSide::end_mm);
    if (side == sides.end()) continue;
    const double piece_mm = glm::length(side->b - side->a);
    const vec2 along = (side->b - side->a) / piece_mm;
    // Small ones are many: the square of an even draw.
    const double size = draw();
    const double half_mm = rules.chip_mm * (0.15 + 0.85 * size * size);
    const double reach_mm = half_mm * (0.25 + 0.35 * draw());
    const vec2 at = side->b - (side->end_mm - at_mm) * along;
    result.push_back({at, bite(at, along, half_mm, reach_mm, seed, address)});
  }
  return result;
}

std::vector<Polygon> bites(const std::vector<Chip>& chips) {
  std::vector<Polygon> result(chips.size());
  std::ranges::transform(chips, result.begin(), &Chip::bite);
  return result;
}

// What bevel and chips leave of a face: strictly inside the outline, in one piece; nothing where the side stays sharp.
std::vector<Region> small_face(const ShardBlank& blank, double bevel_mm, const std::vector<Chip>& chips) {
  if (bevel_mm <= 0.0 || !blank.region.holes.empty()) return {};
  const auto largest = [](const std::vector<Region>& regions) {
    return std::ranges::max_element(regions, {}, [](const Region& region) { return geometry::area(region); });
  };
  const std::vector<Region> inner = geometry::offset(blank.region, -bevel_mm);
  const auto sharp = largest(inner);
  if (sharp == inner.end()) return {};
  const std::vector<Region> chipped = geometry::difference(*sharp, geometry::united(bites(chips)));
  const auto left = largest(chipped);
  if (left == chipped.end()) return {};
  // Rounding to the lattice can make a ring cross itself where a bite leaves a hair of glass. Then the edge stays without
  // chips.
  for (const Region& small : {*left, *sharp}) {
    if (small.holes.empty() && !geometry::region_fault(small.outline, {})) return {small};
  }
  return {};
}

// The same about holes and in several parts, but for those that are splinters.
std::vector<Region> small_faces(const ShardBlank& blank, const ShardRules& rules, double bevel_mm,
                                const std::vector<Chip>& chips) {
  if (bevel_mm <= 0.0) return {};
  const std::vector<Region> removed = geometry::united(bites(chips));
  std::vector<Region> small;
  for (const Region& inner : geometry::offset(blank.region, -bevel_mm)) {
    std::ranges::move(geometry::difference(inner, removed), std::back_inserter(small));
  }
  small = geometry::parted(std::move(small));
  std::erase_if(small, [&](const Region& part) { return geometry::area(part) < rules.splinter_mm2; });
  std::vector<Region> all = small;
  all.push_back(blank.region);
  // A bevel of a few µm is nothing but rounding.
  return geometry::contacts(geometry::rings_of(all)).empty() ? small : std::vector<Region>{};
}

// Builds the surface from rings, each of which is a run of vertices.
class Surface {
 public:
  std::size_t add(const LatticeRing& ring, std::int64_t z) {
    const std::size_t first = solid_.vertices.size();
    for (const LatticePoint p : ring) solid_.vertices.push_back({p.x, p.y, z});
    return first;
  }
  void triangle(std::size_t a, std::size_t b, std::size_t c, int slot) {
    solid_.triangles.push_back(
        {{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)}, slot});
  }
  // The wall between two copies of a ring of n vertices.
  void wall(std::size_t low, std::size_t high, const std::vector<bool>& is_old) {
    const std::size_t n = is_old.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const int slot = is_old[i] ? old_slot : broken_slot;
      triangle(low + i, low + j, high + j, slot);
      triangle(low + i, high + j, high + i, slot);
    }
  }
  // A flat face, seen from the side to which it looks.
  void face(std::span<const LatticeRing> rings, std::size_t first, bool up) {
    for (const auto& [a, b, c] : geometry::triangulation(rings)) cap_triangle({first + a, first + b, first + c}, up, old_slot);
  }
  void cap_triangle(std::array<std::size_t, 3> corners, bool up, int slot) {
    if (up) {
      triangle(corners[0], corners[1], corners[2], slot);
    } else {
      triangle(corners[0], corners[2], corners[1], slot);
    }
  }
  Solid taken() { return std::move(solid_); }

 private:
  Solid solid_;
};

// ---- bevels

// A vertex of a strip of bevel.
struct StripCorner {
  std::size_t vertex = 0;  // of the surface
  std::size_t next = 0;    // the one after it on the border of the blank
  bool on_border = false;
  bool is_old = false;  // the side to the next one
};

// What lies between rings of the blank and of the small faces.
struct Strip {
  std::vector<LatticeRing> rings;
  std::vector<StripCorner> corners;  // of all rings
};

// Vertices of the surface start at `first`.
void append_border(Strip& strip, const LatticeRing& ring, const std::vector<bool>& is_old, std::size_t first) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) strip.corners.push_back({first + i, first + (i + 1) % n, true, is_old[i]});
  strip.rings.push_back(ring);
}

// A ring of a small face, the other way round.
void append_turned(Strip& strip, const LatticeRing& ring, std::size_t first) {
  for (std::size_t i = ring.size(); i-- > 0;) strip.corners.push_back({first + i, 0, false, false});
  strip.rings.emplace_back(ring.rbegin(), ring.rend());
}

// Each hole of a small face holds a strip, and so does the outline; other rings are holes of the innermost that holds them.
//   outer, inner  where the vertices of the blank and of the small faces start, ring after ring
std::vector<Strip> strips(const ShardBlank& blank, std::size_t outer, const std::vector<Region>& small, std::size_t inner) {
  std::vector<Strip> result(1);
  std::vector<const Polygon*> about{&blank.region.outline};
  struct Turned {
    const Polygon* outline;
    std::size_t first;
  };
  std::vector<Turned> outlines;
  for (const Region& region : small) {
    const std::vector<LatticeRing> rings = geometry::lattice_rings(region);
    outlines.push_back({&region.outline, inner});
    inner += rings.front().size();
    for (std::size_t k = 1; k < rings.size(); ++k) {
      append_turned(result.emplace_back(), rings[k], inner);
      about.push_back(&region.holes[k - 1]);
      inner += rings[k].size();
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
  for (std::size_t k = 0; k < borders.size(); ++k) {
    Strip& strip = k == 0 ? result.front() : strip_with(blank.region.holes[k - 1].front());
    append_border(strip, borders[k], blank.is_old[k], outer);
    outer += borders[k].size();
  }
  for (const Turned& turned : outlines) {
    append_turned(strip_with(turned.outline->front()), geometry::lattice_rings({*turned.outline, {}}).front(), turned.first);
  }
  return result;
}

void add_strip(Surface& surface, const Strip& strip, bool up) {
  for (const auto& [a, b, c] : geometry::triangulation(strip.rings)) {
    const std::array<StripCorner, 3> corners{strip.corners[a], strip.corners[b], strip.corners[c]};
    int slot = broken_slot;
    if (std::ranges::none_of(corners, &StripCorner::on_border)) slot = old_slot;
    for (std::size_t i = 0; i < 3; ++i) {
      const StripCorner& next = corners[(i + 1) % 3];
      if (corners[i].is_old && next.on_border && next.vertex == corners[i].next) slot = old_slot;
    }
    surface.cap_triangle({corners[0].vertex, corners[1].vertex, corners[2].vertex}, up, slot);
  }
}

// The bevel between the blank, whose vertices start at `outer`, and the small faces, and these.
void add_bevelled_face(Surface& surface, const ShardBlank& blank, std::size_t outer, const std::vector<Region>& small,
                       std::int64_t z, bool up) {
  std::vector<std::size_t> firsts;
  for (const Region& region : small) {
    const std::vector<LatticeRing> rings = geometry::lattice_rings(region);
    firsts.push_back(surface.add(rings.front(), z));
    for (std::size_t k = 1; k < rings.size(); ++k) surface.add(rings[k], z);
  }
  for (const Strip& strip : strips(blank, outer, small, firsts.front())) add_strip(surface, strip, up);
  for (std::size_t i = 0; i < small.size(); ++i) surface.face(geometry::lattice_rings(small[i]), firsts[i], up);
}

double bevel_of(const ShardBlank& blank, const ShardRules& rules) {
  return std::min(rules.bevel_mm, most_bevel * blank.thickness_mm);
}

// The solid whose front and back are these small faces; none: that side is sharp.
Solid solid(const ShardBlank& blank, double bevel_mm, const std::vector<Region>& front, const std::vector<Region>& back) {
  const std::vector<LatticeRing> rings = geometry::lattice_rings(blank.region);
  const std::int64_t top = geometry::to_lattice(blank.thickness_mm);
  const std::int64_t depth = geometry::to_lattice(bevel_mm);

  // All rings at the lower ends of the walls, then all at the upper ends.
  Surface surface;
  std::size_t count = 0;
  for (const LatticeRing& ring : rings) count = surface.add(ring, back.empty() ? 0 : depth) + ring.size();
  for (const LatticeRing& ring : rings) surface.add(ring, front.empty() ? top : top - depth);
  std::size_t first = 0;
  for (const std::vector<bool>& is_old : blank.is_old) {
    surface.wall(first, count + first, is_old);
    first += is_old.size();
  }
  const auto close = [&](const std::vector<Region>& small, std::size_t at, std::int64_t z, bool up) {
    if (small.empty()) {
      surface.face(rings, at, up);
    } else {
      add_bevelled_face(surface, blank, at, small, z, up);
    }
  };
  close(front, count, top, true);
  close(back, 0, 0, false);
  return surface.taken();
}

}  // namespace

Chips chips(const ShardBlank& blank, const ShardRules& rules, std::uint64_t seed) {
  return {chips_of(blank, rules, blank.id.child("front"), seed), chips_of(blank, rules, blank.id.child("back"), seed)};
}

Solid shard_solid(const ShardBlank& blank, const ShardRules& rules, std::uint64_t seed) {
  const double bevel_mm = bevel_of(blank, rules);
  const auto [front, back] = chips(blank, rules, seed);
  return solid(blank, bevel_mm, small_face(blank, bevel_mm, front), small_face(blank, bevel_mm, back));
}

Solid joined_solid(const ShardBlank& blank, const ShardRules& rules, const Chips& chips) {
  const double bevel_mm = bevel_of(blank, rules);
  return solid(blank, bevel_mm, small_faces(blank, rules, bevel_mm, chips.front),
               small_faces(blank, rules, bevel_mm, chips.back));
}

}  // namespace shatterpave::glass
