// Fragments are Voronoi cells of seeds that are drawn, one to a fragment, in rings about the impact, in the plane that
// DiceShape unfolds, where all fragments are as long as wide. Seeds move once to the middles of their cells (Lloyd): raw cells
// have needles, and more would make a honeycomb. Corners too near to each other become one. Then cracks run along the sides of
// cells, from the impact outwards, on the CrackMap, which keeps them from crossing whatever folding and rounding did to the
// sides.
#include "glass/dicing/dice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "geometry/lattice.h"
#include "geometry/region_index.h"
#include "geometry/voronoi.h"
#include "glass/dicing/dice_shape.h"
#include "glass/map/crack_map.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;

// Sides shorter than this part of a fragment's width are no sides; by eye.
constexpr double least_side = 0.15;

// How far seeds move to the middles of their cells; by eye.
constexpr double settling = 0.7;

// Where three cracks meet, two are one that runs through, and the third ends on it: so often, and by this part of the way, a
// corner moves to the straight line between those before and behind it on the crack that runs through. Cells alone meet at
// 120°, as foam does. By eye, beside the photographs that dice_shape.cpp names.
constexpr int straightenings = 2;
constexpr double straightening = 0.5;

// All corners that are as near to the impact as this, in widths of a fragment there, are one with it.
constexpr double star_radius = 0.5;

// Sides bend where splinters are folded: they get a vertex for each so many widths of a fragment.
constexpr double widths_to_a_vertex = 2.5;
constexpr double most_pieces = 8.0;

// Seeds beyond the pane, in lengths of a fragment: so many that cells at the edge have all their neighbours.
constexpr double margin_lengths = 3.0;

// Rings of seeds are no wider than this share of the distance from the impact and a fragment: in wider ones as many seeds would
// stand within as without. By eye.
constexpr double steepest_rings = 0.6;

struct Side {
  std::uint32_t a = 0;
  std::uint32_t b = 0;

  auto operator<=>(const Side&) const = default;
};

// Corners and sides of all fragments.
struct Fragments {
  std::vector<vec2> unfolded;
  std::vector<LatticePoint> places;
  std::vector<Side> sides;
  std::uint32_t star = 0;  // the corner at the impact
};

double farthest(const geometry::Polygon& outline, vec2 from) {
  double distance = 0.0;
  for (const vec2& vertex : outline) distance = std::max(distance, glm::length(vertex - from));
  return distance;
}

// One to a fragment, unfolded: in rings as wide as fragments are long, somewhere in a place of its own.
std::vector<vec2> drawn_seeds(const Pane& pane, const DiceShape& shape, vec2 impact, double reach_mm, std::uint64_t seed) {
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  std::vector<vec2> seeds;
  double inner = 0.0;
  for (std::uint64_t ring = 0; inner < reach_mm; ++ring) {
    const double full = shape.length_mm(inner);
    const double length = std::min(full, steepest_rings * inner + shape.width_mm(inner));
    const double middle = inner + 0.5 * length;
    const double count = std::max(std::round(2.0 * pi * middle / shape.width_mm(middle) * (length / full)), 3.0);
    const vec2 margin = margin_lengths * vec2{length, length};
    const Id id = Id(pane.name).child("dice").child(ring);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
      const double turn = 2.0 * pi / count;
      const vec2 near = impact + middle * Angle::radians(turn * (i + 0.5)).direction();
      if (glm::any(glm::lessThan(near, box.low - margin)) || glm::any(glm::greaterThan(near, box.high + margin))) continue;
      const Angle direction = Angle::radians(turn * (i + uniform(seed, {Stream::dice_seed, id, 2 * i})));
      const double distance = inner + length * uniform(seed, {Stream::dice_seed, id, 2 * i + 1});
      seeds.push_back(geometry::on_lattice(shape.unfolded(impact + distance * direction.direction())));
    }
    inner += length;
  }
  geometry::sort_distinct(seeds);
  return seeds;
}

// Moves seeds on their way to the middles of their cells, but those at the rim, whose cells are of any size.
void settle(std::vector<vec2>& seeds, const DiceShape& shape, vec2 impact) {
  const geometry::Voronoi cells = geometry::voronoi(seeds);
  for (std::size_t s = 0; s < seeds.size(); ++s) {
    if (cells.cells[s].empty()) continue;
    const vec2 middle = geometry::on_lattice(glm::mix(seeds[s], geometry::centroid(cells.outline(s)), settling));
    const double width = shape.unfolded_width(glm::length(shape.folded(seeds[s]) - impact));
    if (glm::length(middle - seeds[s]) < width) seeds[s] = middle;
  }
  geometry::sort_distinct(seeds);
}

std::vector<Side> sides_of(const geometry::Voronoi& cells) {
  std::vector<Side> sides;
  for (const auto& cell : cells.cells) {
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const Side side{cell[k], cell[(k + 1) % cell.size()]};
      if (side.a < side.b) sides.push_back(side);  // the cell on the other side has it the other way round
    }
  }
  return sides;
}

// Which corner each corner becomes: the ends of a short side one of the two, those at the impact all the same.
std::vector<std::uint32_t> joined(Fragments& fragments, const DiceShape& shape, vec2 impact) {
  std::vector<std::uint32_t> stands(fragments.unfolded.size());
  std::iota(stands.begin(), stands.end(), 0U);
  std::vector<bool> taken(stands.size(), false);
  const auto distance = [&](std::uint32_t c) { return glm::length(shape.folded(fragments.unfolded[c]) - impact); };
  double nearest = distance(fragments.star);
  std::vector<std::uint32_t> at_impact;
  for (std::uint32_t c = 0; c < stands.size(); ++c) {
    const double r = distance(c);
    if (r < star_radius * shape.width_mm(0.0)) at_impact.push_back(c);
    if (r < nearest) {
      nearest = r;
      fragments.star = c;
    }
  }
  for (const std::uint32_t c : at_impact) {
    stands[c] = fragments.star;
    taken[c] = true;
  }
  taken[fragments.star] = true;
  fragments.unfolded[fragments.star] = {0.0, 0.0};
  for (const auto& [a, b] : fragments.sides) {
    if (taken[a] || taken[b]) continue;
    const vec2 middle = 0.5 * (fragments.unfolded[a] + fragments.unfolded[b]);
    const double width = shape.unfolded_width(glm::length(shape.folded(middle) - impact));
    if (glm::length(fragments.unfolded[b] - fragments.unfolded[a]) >= least_side * width) continue;
    taken[a] = taken[b] = true;
    stands[b] = a;
    fragments.unfolded[a] = middle;
  }
  return stands;
}

// The middle of the two others, of those round a corner, that are most nearly opposite to each other.
vec2 middle_of_opposites(vec2 corner, const std::vector<vec2>& others) {
  vec2 middle = corner;
  double least_cosine = 1.0;
  for (std::size_t i = 0; i < others.size(); ++i) {
    for (std::size_t j = i + 1; j < others.size(); ++j) {
      const vec2 a = others[i] - corner;
      const vec2 b = others[j] - corner;
      const double lengths = glm::length(a) * glm::length(b);
      const double cosine = lengths > 0.0 ? glm::dot(a, b) / lengths : 1.0;
      if (cosine >= least_cosine) continue;
      least_cosine = cosine;
      middle = 0.5 * (others[i] + others[j]);
    }
  }
  return middle;
}

// Cracks run on through corners, each as nearly straight as it can. Splinters, whose sides are straight as they are, stay.
void straighten(Fragments& fragments, const DiceShape& shape, vec2 impact) {
  std::vector<std::vector<std::uint32_t>> around(fragments.unfolded.size());
  for (const auto& [a, b] : fragments.sides) {
    around[a].push_back(b);
    around[b].push_back(a);
  }
  std::vector<vec2> others;
  for (int round = 0; round < straightenings; ++round) {
    const std::vector<vec2> before = fragments.unfolded;
    for (std::uint32_t corner = 0; corner < before.size(); ++corner) {
      if (corner == fragments.star || around[corner].size() < 3) continue;
      others.clear();
      for (const std::uint32_t other : around[corner]) others.push_back(before[other]);
      const double share = straightening * shape.far_share(glm::length(shape.folded(before[corner]) - impact));
      fragments.unfolded[corner] = glm::mix(before[corner], middle_of_opposites(before[corner], others), share);
    }
  }
}

// A crack from the star, by the direction in which it leaves.
struct Ray {
  double direction = 0.0;
  Side side;
};

// The ray between the two nearest others, of those for which `may_go` holds. Rays are in order of direction, round the circle.
template <typename MayGo>
std::optional<std::size_t> narrowest_of(const std::vector<Ray>& rays, MayGo may_go) {
  std::optional<std::size_t> best;
  double narrowest = 2.0 * pi;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!may_go(rays[i])) continue;
    const double on = rays[(i + 1) % rays.size()].direction + (i + 1 == rays.size() ? 2.0 * pi : 0.0);
    const double back = rays[(i + rays.size() - 1) % rays.size()].direction - (i == 0 ? 2.0 * pi : 0.0);
    if (on - back >= narrowest) continue;
    narrowest = on - back;
    best = i;
  }
  return best;
}

// The cracks that start at the impact are as far apart as splinters where the star of corners that became one with it ends:
// those between the narrowest are left out, so that pairs of splinters grow together to the corner where the next begins. Which
// is how cracks branch on their way out.
void thin_star(Fragments& fragments, const DiceShape& shape) {
  const auto wanted = static_cast<std::size_t>(
      std::max(std::round(2.0 * pi * star_radius * shape.width_mm(0.0) / shape.splinter_spacing_mm()), 3.0));
  std::vector<Ray> rays;
  std::vector<int> degrees(fragments.places.size(), 0);
  const vec2 impact = geometry::to_mm(fragments.places[fragments.star]);
  const auto end_of = [&](const Side& side) { return side.a == fragments.star ? side.b : side.a; };
  for (const Side& side : fragments.sides) {
    ++degrees[side.a];
    ++degrees[side.b];
    if (side.a != fragments.star && side.b != fragments.star) continue;
    rays.push_back({Angle::of(geometry::to_mm(fragments.places[end_of(side)]) - impact).radians(), side});
  }
  std::ranges::sort(rays, {}, [](const Ray& ray) { return std::pair(ray.direction, ray.side); });
  while (rays.size() > wanted) {
    const auto best = narrowest_of(rays, [&](const Ray& ray) { return degrees[end_of(ray.side)] >= 3; });
    if (!best) return;
    --degrees[end_of(rays[*best].side)];
    std::erase(fragments.sides, rays[*best].side);
    rays.erase(rays.begin() + static_cast<std::ptrdiff_t>(*best));
  }
}

Fragments fragments_of(const geometry::Voronoi& cells, const DiceShape& shape, vec2 impact) {
  Fragments fragments{cells.corners, {}, sides_of(cells), 0};
  const std::vector<std::uint32_t> stands = joined(fragments, shape, impact);
  for (Side& side : fragments.sides) {
    const std::uint32_t a = stands[side.a];
    const std::uint32_t b = stands[side.b];
    side = {std::min(a, b), std::max(a, b)};
  }
  std::ranges::sort(fragments.sides);
  fragments.sides.erase(std::unique(fragments.sides.begin(), fragments.sides.end()), fragments.sides.end());
  std::erase_if(fragments.sides, [](const Side& side) { return side.a == side.b; });
  straighten(fragments, shape, impact);
  for (const vec2& corner : fragments.unfolded) fragments.places.push_back(geometry::to_lattice(shape.folded(corner)));
  fragments.places[fragments.star] = geometry::to_lattice(impact);
  thin_star(fragments, shape);
  return fragments;
}

// Of fracture: a circle about the impact that grows.
struct Front {
  vec2 impact_mm{0.0, 0.0};
  double start_us = 0.0;
  double speed_mm_us = 1.0;

  double reaches_us(LatticePoint p) const { return start_us + glm::length(geometry::to_mm(p) - impact_mm) / speed_mm_us; }
};

// Lets cracks run along the sides of fragments.
class Running {
 public:
  Running(const Fragments& fragments, const DiceShape& shape, const Front& front, CrackMap& map)
      : fragments_(fragments),
        shape_(shape),
        front_(front),
        map_(map),
        first_(fragments.places.size() + 1, 0),
        used_(fragments.sides.size(), false),
        hubs_(fragments.places.size(), none),
        reached_(fragments.places.size(), false) {
    for (const Side& side : fragments.sides) {
      ++first_[side.a + 1];
      ++first_[side.b + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    around_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t s = 0; s < fragments.sides.size(); ++s) {
      around_[next[fragments.sides[s].a]++] = s;
      around_[next[fragments.sides[s].b]++] = s;
    }
  }

  // From the corner on to all that hangs together with it, where the map lets cracks through.
  void spread_from(std::uint32_t corner, CrackEnd::At start) {
    const bool has_sides = first_[corner] < first_[corner + 1];
    if (reached_[corner] || !has_sides || map_.is_taken(fragments_.places[corner])) return;
    reached_[corner] = true;
    hubs_[corner] = map_.add_hub(fragments_.places[corner]);
    std::vector<std::uint32_t> waiting{corner};
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      const std::uint32_t from = waiting[i];
      for (std::uint32_t k = first_[from]; k < first_[from + 1]; ++k) {
        if (!used_[around_[k]]) run(from, around_[k], i == 0 ? start : CrackEnd::At::crack, waiting);
      }
    }
  }

  bool is_reached(std::uint32_t corner) const { return reached_[corner]; }

 private:
  static constexpr CrackMap::Hub none = -1;

  std::uint32_t other(std::uint32_t side, std::uint32_t corner) const {
    const Side& ends = fragments_.sides[side];
    return ends.a == corner ? ends.b : ends.a;
  }

  // A crack from the corner along the side and on. Corners that it comes to first go to `waiting`.
  void run(std::uint32_t corner, std::uint32_t side, CrackEnd::At start, std::vector<std::uint32_t>& waiting) {
    if (hubs_[corner] == none) hubs_[corner] = map_.add_hub(fragments_.places[corner]);
    const int crack = map_.start(hubs_[corner], CrackKind::dice, 0, start, front_.reaches_us(fragments_.places[corner]));
    for (std::uint32_t from = corner;;) {
      used_[side] = true;
      const std::uint32_t to = other(side, from);
      if (!follow(crack, from, to)) return;
      const std::optional<std::uint32_t> next = reached_[to] ? std::nullopt : straightest(from, to);
      if (!reached_[to]) waiting.push_back(to);
      reached_[to] = true;
      if (!next) return map_.stop(crack, CrackEnd::At::open);
      from = to;
      side = *next;
    }
  }

  // Leads the crack from one corner to the next. Returns whether it came there.
  bool follow(int crack, std::uint32_t from, std::uint32_t to) {
    const vec2 a = fragments_.unfolded[from];
    const vec2 b = fragments_.unfolded[to];
    const vec2 start = geometry::to_mm(fragments_.places[from]);
    const double length = glm::length(geometry::to_mm(fragments_.places[to]) - start);
    const double width = shape_.width_mm(glm::length(start - front_.impact_mm));
    const double pieces = from == fragments_.star || to == fragments_.star
                              ? 1.0
                              : std::clamp(std::ceil(length / (widths_to_a_vertex * width)), 1.0, most_pieces);
    for (double piece = 1.0; piece < pieces; ++piece) {
      if (run_to(crack, geometry::to_lattice(shape_.folded(glm::mix(a, b, piece / pieces))))) return false;
    }
    return !run_to(crack, fragments_.places[to]);
  }

  // With the front, or at once to where it has been.
  std::optional<Arrest> run_to(int crack, LatticePoint to) {
    return map_.extend(crack, to, std::max(map_.tip_us(crack), front_.reaches_us(to)));
  }

  // The side on which a crack that comes along a side leaves its end.
  std::optional<std::uint32_t> straightest(std::uint32_t from, std::uint32_t at) const {
    const vec2 here = geometry::to_mm(fragments_.places[at]);
    const vec2 heading = here - geometry::to_mm(fragments_.places[from]);
    std::optional<std::uint32_t> best;
    double best_cosine = -2.0 * glm::length(heading);
    for (std::uint32_t k = first_[at]; k < first_[at + 1]; ++k) {
      if (used_[around_[k]]) continue;
      const vec2 way = geometry::to_mm(fragments_.places[other(around_[k], at)]) - here;
      const double length = glm::length(way);
      const double cosine = length > 0.0 ? glm::dot(heading, way) / length : 0.0;
      if (cosine > best_cosine) {
        best = around_[k];
        best_cosine = cosine;
      }
    }
    return best;
  }

  const Fragments& fragments_;
  const DiceShape& shape_;
  Front front_;
  CrackMap& map_;
  std::vector<std::uint32_t> first_;  // sides at corner c are around_[first_[c]] … around_[first_[c + 1] − 1]
  std::vector<std::uint32_t> around_;
  std::vector<bool> used_;           // sides
  std::vector<CrackMap::Hub> hubs_;  // of corners at which cracks start
  std::vector<bool> reached_;        // corners that a crack went through, or started from
};

}  // namespace

void require_few_fragments(const Pane& pane, const Tempered& glass) {
  const double count = geometry::area(pane.outline_mm) / 2500.0 * fragment_count(pane, glass);
  if (count <= most_fragments) return;
  throw InputError(
      Place{"", 0, 0, pane.name + ".tempering"},
      fmt::format("expected a pane of tempered glass of at most {:.0f} fragments, got one of {:.0f}", most_fragments, count));
}

CrackNetwork diced_pane(const Pane& pane, const Tempered& glass, std::uint64_t seed) {
  require_few_fragments(pane, glass);
  CrackNetwork network;
  for (const Impact& impact : pane.impacts) network.impacts.emplace_back().at_mm = geometry::on_lattice(impact.at_mm);
  if (pane.impacts.empty()) return network;
  const vec2 impact = network.impacts.front().at_mm;
  const double side_mm = std::sqrt(2500.0 / fragment_count(pane, glass));
  const double reach_mm = farthest(pane.outline_mm, impact) + 2.0 * margin_lengths * side_mm;
  const DiceShape shape(pane, glass, impact, reach_mm);
  std::vector<vec2> seeds = drawn_seeds(pane, shape, impact, reach_mm, seed);
  settle(seeds, shape, impact);
  const Fragments fragments = fragments_of(geometry::voronoi(seeds), shape, impact);

  CrackMap map(pane.outline_mm, side_mm, false);
  const Front front{impact, pane.impacts.front().time_us, pane.growth.crack_speed_m_s / 1000.0};
  Running running(fragments, shape, front, map);
  running.spread_from(fragments.star, CrackEnd::At::impact);
  const geometry::RegionIndex inside({pane.outline_mm, {}});
  for (std::uint32_t corner = 0; corner < fragments.places.size(); ++corner) {
    const vec2 place = geometry::to_mm(fragments.places[corner]);
    if (!running.is_reached(corner) && inside.contains(place)) running.spread_from(corner, CrackEnd::At::origin);
  }
  network.cracks = map.cracks(pane.time_us.has_value());
  const auto from_impact = [](const Crack& crack) { return crack.start.at == CrackEnd::At::impact; };
  network.impacts.front().radial_count = static_cast<int>(std::ranges::count_if(network.cracks, from_impact));
  return network;
}

}  // namespace shatterpave::glass
