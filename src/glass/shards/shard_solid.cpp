// Walls stand on the outline; from their ends bevels lead to the flat parts of front and back, which are the outline moved
// inwards less the bites of chips, so that these make the bevel wide where they are. See shard_bevel.h for how sides close.
#include "glass/shards/shard_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "geometry/clip.h"
#include "geometry/contacts.h"
#include "geometry/triangulation.h"
#include "glass/shards/shard_bevel.h"
#include "glass/shards/shards.h"

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

// The ring without vertices that lie within a few µm of the one before: cutting makes such pairs, and triangles at them are
// needles.
void drop_short_sides(Polygon& ring) {
  constexpr double least_mm = 0.004;
  Polygon kept;
  for (const vec2 p : ring) {
    if (kept.empty() || glm::length(p - kept.back()) >= least_mm) kept.push_back(p);
  }
  while (kept.size() > 1 && glm::length(kept.front() - kept.back()) < least_mm) kept.pop_back();
  if (kept.size() >= 3) ring = std::move(kept);
}

// What bevel and bites leave of a face, but for hairs of it.
std::vector<Region> flats_within(const ShardBlank& blank, double bevel_mm, const std::vector<Region>& bitten) {
  std::vector<Region> flats;
  for (const Region& inner : geometry::offset(blank.region, -bevel_mm)) {
    std::ranges::move(geometry::difference(inner, bitten), std::back_inserter(flats));
  }
  flats = geometry::parted(std::move(flats));
  for (Region& flat : flats) {
    drop_short_sides(flat.outline);
    std::ranges::for_each(flat.holes, drop_short_sides);
  }
  // Smaller than a bevel is wide, it is where bevels meet.
  std::erase_if(flats, [&](const Region& part) { return geometry::area(part) < bevel_mm * bevel_mm; });
  return flats;
}

// The flat parts of a side, strictly within the blank; none where it stays sharp.
std::vector<Region> flat_parts(const ShardBlank& blank, double bevel_mm, const std::vector<Chip>& chips) {
  if (bevel_mm <= 0.0) return {};
  // Rounding to the lattice can make rings touch where a bite leaves a hair of glass, and a bevel of a few µm is nothing but
  // rounding. Then the side stays without chips, or without bevel.
  for (const std::vector<Region>& bitten : {geometry::united(bites(chips)), std::vector<Region>{}}) {
    std::vector<Region> flats = flats_within(blank, bevel_mm, bitten);
    std::vector<Region> all = flats;
    all.push_back(blank.region);
    if (!flats.empty() && geometry::contacts(geometry::rings_of(all)).empty()) return flats;
  }
  return {};
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
  // The same where the two copies are shifted: each face is parted by the diagonal that its plan tells, whichever way the ring
  // runs, so that walls on both sides of a crack are parted alike.
  void leaning_wall(std::size_t low, std::size_t high, const Polygon& plan, const std::vector<bool>& is_old) {
    const std::size_t n = is_old.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const int slot = is_old[i] ? old_slot : broken_slot;
      if (plan[i].x < plan[j].x || (plan[i].x == plan[j].x && plan[i].y < plan[j].y)) {
        triangle(low + i, low + j, high + j, slot);
        triangle(low + i, high + j, high + i, slot);
      } else {
        triangle(low + i, low + j, high + i, slot);
        triangle(low + j, high + j, high + i, slot);
      }
    }
  }
  // A side over the border that starts at vertex `border` and lies at height z. `outwards` is +1 for the front, −1 for the
  // back.
  void cap(const ShardSide& side, std::size_t border, std::size_t border_count, std::int64_t z, int outwards) {
    const std::size_t others = solid_.vertices.size();
    for (const ShardSide::Vertex& vertex : side.vertices) {
      solid_.vertices.push_back({vertex.plan.x, vertex.plan.y, z + outwards * vertex.rise_um});
    }
    const auto number = [&](std::size_t v) { return v < border_count ? border + v : others + v - border_count; };
    for (const auto& [corners, surface] : side.triangles) {
      const auto [a, b, c] = corners;
      const int slot = static_cast<int>(surface);
      triangle(number(a), number(outwards > 0 ? b : c), number(outwards > 0 ? c : b), slot);
    }
  }
  Solid taken() { return std::move(solid_); }

 private:
  Solid solid_;
};

double bevel_of(const ShardBlank& blank, const ShardRules& rules) {
  return std::min(rules.bevel_mm, most_bevel * blank.thickness_mm);
}

// The solid whose front and back have these flat parts; none: that side is sharp.
Solid solid(const ShardBlank& blank, double bevel_mm, const std::vector<Region>& front, const std::vector<Region>& back) {
  const std::vector<LatticeRing> rings = geometry::lattice_rings(blank.region);
  const std::int64_t depth_um = geometry::to_lattice(bevel_mm);
  const std::int64_t low = back.empty() ? 0 : depth_um;
  const std::int64_t high = geometry::to_lattice(blank.thickness_mm) - (front.empty() ? 0 : depth_um);

  // All rings at the lower ends of the walls, then all at the upper ends.
  Surface surface;
  std::size_t count = 0;
  for (const LatticeRing& ring : rings) count = surface.add(ring, low) + ring.size();
  for (const LatticeRing& ring : rings) surface.add(ring, high);
  std::size_t first = 0;
  for (const std::vector<bool>& is_old : blank.is_old) {
    surface.wall(first, count + first, is_old);
    first += is_old.size();
  }
  const auto side = [&](const std::vector<Region>& flats) {
    return flats.empty() ? sharp_side(blank) : bevelled_side(blank, flats, depth_um);
  };
  surface.cap(side(front), count, count, high, 1);
  surface.cap(side(back), 0, count, low, -1);
  return surface.taken();
}

// ---- where walls lean

// Rows of faces from border to border: more do not show in walls that bow by a few degrees.
constexpr std::size_t wall_rows = 4;
// Shifted sides are straight to this part of the gap; so walls of two pieces keep what the field leaves between them.
constexpr double straight_part = 0.1;
// Vertices nearer than this are one: shifted, they might come to lie in one place.
constexpr double least_side_mm = 0.008;

// Each ring of the blank with what of its sides is old, the outline first.
template <typename Act>
void each_ring(ShardBlank& blank, const Act& act) {
  act(blank.region.outline, blank.is_old.front());
  for (std::size_t i = 0; i < blank.region.holes.size(); ++i) act(blank.region.holes[i], blank.is_old[i + 1]);
}

void drop_near_vertices(Polygon& ring, std::vector<bool>& is_old) {
  Polygon kept;
  std::vector<bool> kept_is_old;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const bool is_near = !kept.empty() && glm::length(ring[i] - kept.back()) < least_side_mm;
    if (is_near) {
      kept_is_old.back() = is_old[i];
      continue;
    }
    kept.push_back(ring[i]);
    kept_is_old.push_back(is_old[i]);
  }
  while (kept.size() > 3 && glm::length(kept.front() - kept.back()) < least_side_mm) {
    kept.pop_back();
    kept_is_old.pop_back();
  }
  if (kept.size() < 3) return;
  ring = std::move(kept);
  is_old = std::move(kept_is_old);
}

ShardBlank shifted(ShardBlank blank, const Lean& lean, double z_mm) {
  each_ring(blank, [&](Polygon& ring, const std::vector<bool>& /*is_old*/) {
    for (vec2& p : ring) p = geometry::on_lattice(p + lean.aside_mm(p, z_mm));
  });
  return blank;
}

std::vector<Chip> shifted(std::vector<Chip> chips, const Lean& lean, double z_mm) {
  for (Chip& chip : chips) {
    for (vec2& p : chip.bite) p = geometry::on_lattice(p + lean.aside_mm(chip.at_mm, z_mm));
  }
  return chips;
}

bool keeps_apart(ShardBlank blank) {
  bool has_sides = true;
  each_ring(blank, [&](const Polygon& ring, const std::vector<bool>& /*is_old*/) {
    for (std::size_t i = 0; i < ring.size(); ++i) has_sides = has_sides && ring[i] != ring[(i + 1) % ring.size()];
  });
  return has_sides && geometry::contacts(geometry::rings_of({blank.region})).empty();
}

struct LeaningSide {
  ShardBlank blank;  // as it is shifted at the border of the side
  std::vector<Region> flats;
  std::int64_t z = 0;  // of the border
};

// `outwards` is +1 for the front, −1 for the back; no blank where sides meet.
std::optional<LeaningSide> leaning_side(const ShardBlank& plan, const Lean& lean, double bevel_mm,
                                        const std::vector<Chip>& chips, int outwards) {
  const double half_mm = 0.5 * plan.thickness_mm;
  const std::int64_t face = outwards > 0 ? geometry::to_lattice(plan.thickness_mm) : 0;
  LeaningSide side{shifted(plan, lean, outwards * (half_mm - bevel_mm)), {}, face - outwards * geometry::to_lattice(bevel_mm)};
  if (!keeps_apart(side.blank)) return std::nullopt;
  side.flats = flat_parts(side.blank, bevel_mm, shifted(chips, lean, outwards * half_mm));
  if (!side.flats.empty()) return side;
  side = {shifted(plan, lean, outwards * half_mm), {}, face};
  return keeps_apart(side.blank) ? std::optional(side) : std::nullopt;
}

// As `solid`.
Solid leaning_solid(ShardBlank plan, const ShardRules& rules, const Chips& chips, const Lean& lean) {
  const double bevel_mm = bevel_of(plan, rules);
  each_ring(plan, [&](Polygon& ring, std::vector<bool>& is_old) {
    drop_near_vertices(ring, is_old);
    ring = lean.followed(ring, is_old, straight_part * rules.gap_mm);
  });
  const auto front = leaning_side(plan, lean, bevel_mm, chips.front, 1);
  const auto back = leaning_side(plan, lean, bevel_mm, chips.back, -1);
  if (!front || !back) return {};
  Surface surface;
  std::size_t count = 0;  // of the vertices of a row
  for (std::size_t row = 0; row <= wall_rows; ++row) {
    const std::int64_t z =
        back->z + (front->z - back->z) * static_cast<std::int64_t>(row) / static_cast<std::int64_t>(wall_rows);
    const ShardBlank at = row == 0           ? back->blank
                          : row == wall_rows ? front->blank
                                             : shifted(plan, lean, geometry::to_mm(z) - 0.5 * plan.thickness_mm);
    const std::size_t first = row * count;
    for (const LatticeRing& ring : geometry::lattice_rings(at.region)) count = surface.add(ring, z) + ring.size() - first;
  }
  std::size_t ring_first = 0;
  each_ring(plan, [&](const Polygon& ring, const std::vector<bool>& is_old) {
    for (std::size_t row = 0; row < wall_rows; ++row) {
      surface.leaning_wall(row * count + ring_first, (row + 1) * count + ring_first, ring, is_old);
    }
    ring_first += ring.size();
  });
  const auto cap = [&](const LeaningSide& of, std::size_t border, int outwards) {
    const std::int64_t depth_um = geometry::to_lattice(bevel_mm);
    surface.cap(of.flats.empty() ? sharp_side(of.blank) : bevelled_side(of.blank, of.flats, depth_um), border, count, of.z,
                outwards);
  };
  cap(*front, wall_rows * count, 1);
  cap(*back, 0, -1);
  return surface.taken();
}

}  // namespace

Chips chips(const ShardBlank& blank, const ShardRules& rules, std::uint64_t seed) {
  return {chips_of(blank, rules, blank.id.child("front"), seed), chips_of(blank, rules, blank.id.child("back"), seed)};
}

Solid shard_solid(const ShardBlank& blank, const ShardRules& rules, const Chips& chips, const Lean& lean) {
  if (!lean.is_upright()) return leaning_solid(blank, rules, chips, lean);
  const double bevel_mm = bevel_of(blank, rules);
  return solid(blank, bevel_mm, flat_parts(blank, bevel_mm, chips.front), flat_parts(blank, bevel_mm, chips.back));
}

}  // namespace shatterpave::glass
