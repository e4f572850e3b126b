// Between a sharp face and the upper end of the walls lies a bevel: the ring between the outline and a smaller face inside it,
// parted into triangles in the plane and lifted, each vertex to the height of the ring that it is of. So it closes whatever the
// two look like. Chips are bites off the smaller face, which make the bevel wide there.
#include "glass/shard_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "geometry/clip.h"
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
  const Polygon& outline = blank.region.outline;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (blank.is_old.front()[i]) continue;
    const vec2 b = outline[(i + 1) % outline.size()];
    length_mm += glm::length(b - outline[i]);
    sides.push_back({outline[i], b, length_mm});
  }
  return sides;
}

// Bites off the broken edges of one face of the shard.
std::vector<Polygon> bites(const ShardBlank& blank, const ShardRules& rules, Id face, std::uint64_t seed) {
  const std::vector<BrokenSide> sides = broken_sides(blank);
  std::vector<Polygon> result;
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
    result.push_back(bite(side->b - (side->end_mm - at_mm) * along, along, half_mm, reach_mm, seed, address));
  }
  return result;
}

// What bevel and chips leave of a face: strictly inside the outline, in one piece.
std::optional<LatticeRing> small_face(const ShardBlank& blank, const ShardRules& rules, double bevel_mm, Id face,
                                      std::uint64_t seed) {
  if (bevel_mm <= 0.0 || !blank.region.holes.empty()) return std::nullopt;
  const auto largest = [](const std::vector<Region>& regions) {
    return std::ranges::max_element(regions, {}, [](const Region& region) { return geometry::area(region); });
  };
  const std::vector<Region> inner = geometry::offset(blank.region, -bevel_mm);
  const auto sharp = largest(inner);
  if (sharp == inner.end()) return std::nullopt;
  const std::vector<Region> chipped = geometry::difference(*sharp, geometry::united(bites(blank, rules, face, seed)));
  const auto left = largest(chipped);
  if (left == chipped.end()) return std::nullopt;
  // Rounding to the lattice can make a ring cross itself where a bite leaves a hair of glass. Then the edge stays without
  // chips.
  for (const Region& small : {*left, *sharp}) {
    if (small.holes.empty() && !geometry::region_fault(small.outline, {})) return geometry::lattice_rings(small).front();
  }
  return std::nullopt;
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

// The bevel between the outline, whose vertices start at `outer`, and the small face, and that face.
void add_bevelled_face(Surface& surface, const LatticeRing& outline, std::size_t outer, const LatticeRing& small,
                       std::int64_t z, bool up, const std::vector<bool>& is_old) {
  const std::size_t inner = surface.add(small, z);
  const std::size_t n = outline.size();
  const std::size_t m = small.size();
  std::vector<LatticeRing> ring{outline, LatticeRing(small.rbegin(), small.rend())};
  const auto vertex = [&](std::size_t corner) { return corner < n ? outer + corner : inner + m - 1 - (corner - n); };
  for (const auto& corners : geometry::triangulation(ring)) {
    int slot = broken_slot;
    if (std::ranges::all_of(corners, [&](std::size_t c) { return c >= n; })) slot = old_slot;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = corners[i];
      if (a < n && corners[(i + 1) % 3] == (a + 1) % n && is_old[a]) slot = old_slot;
    }
    surface.cap_triangle({vertex(corners[0]), vertex(corners[1]), vertex(corners[2])}, up, slot);
  }
  surface.face(std::span(&small, 1), inner, up);
}

}  // namespace

Solid shard_solid(const ShardBlank& blank, const ShardRules& rules, std::uint64_t seed) {
  const std::vector<LatticeRing> rings = geometry::lattice_rings(blank.region);
  const double bevel_mm = std::min(rules.bevel_mm, most_bevel * blank.thickness_mm);
  const std::optional<LatticeRing> front = small_face(blank, rules, bevel_mm, blank.id.child("front"), seed);
  const std::optional<LatticeRing> back = small_face(blank, rules, bevel_mm, blank.id.child("back"), seed);
  const std::int64_t top = geometry::to_lattice(blank.thickness_mm);
  const std::int64_t depth = geometry::to_lattice(bevel_mm);

  // All rings at the lower ends of the walls, then all at the upper ends.
  Surface surface;
  std::size_t count = 0;
  for (const LatticeRing& ring : rings) count = surface.add(ring, back ? depth : 0) + ring.size();
  for (const LatticeRing& ring : rings) surface.add(ring, front ? top - depth : top);
  std::size_t first = 0;
  for (const std::vector<bool>& is_old : blank.is_old) {
    surface.wall(first, count + first, is_old);
    first += is_old.size();
  }
  const auto close = [&](const std::optional<LatticeRing>& small, std::size_t at, std::int64_t z, bool up) {
    if (small) {
      add_bevelled_face(surface, rings.front(), at, *small, z, up, blank.is_old.front());
    } else {
      surface.face(rings, at, up);
    }
  };
  close(front, count, top, true);
  close(back, 0, 0, false);
  return surface.taken();
}

}  // namespace shatterpave::glass
