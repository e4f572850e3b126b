// The model in outline. An impact gets its counts (eq. 3, 5, 6), its radials, at equal angles, and the starting points of its
// ring cracks. Then time goes on in steps of dt: every growing tip looks into the sector in front of it, turns by the forces of
// what it sees there, and goes on, until all large and ring cracks have stopped.
//
// Departures from the paper, most by a parameter of Growth:
// - a tip turns by its length, not by its steps (turn_length);
// - ring cracks start when the large cracks are out of their way (ring_onset);
// - a pull along its circle keeps a ring crack on it (ring_pull), where the paper states the rule without a formula;
// - a weak pull keeps radials on their way out, however large the pane is (radial_pull);
// - F2 between radials of one impact has a gain of its own (sibling_gain).
// - the second stop rule spares ring cracks: stopped in the middle of a region they would float in the glass, touching nothing.
// In F1 only the nearest tips count (nearest_tips), in F2 only the nearest crack: with the square of the distance in the
// denominator the rest hardly shows, and where radials crowd about the impact all pairs would be too many.
#include "glass/growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "geometry/point_index.h"
#include "geometry/predicates.h"
#include "glass/counts.h"
#include "glass/crack_map.h"
#include "glass/steering.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;
using geometry::Sector;
using geometry::SegmentIndex;

// Tips that F1 looks at. By eye: beyond four nothing changes in a picture; eight is on the safe side.
constexpr std::size_t nearest_tips = 8;

// Radials start straight for as long as neighbours are nearer than this: half the thinnest crack that a picture can show, and
// so many units of the lattice that rounding swaps no two of them. At M = 100 that is the first 0.8 mm, at M = 10,000 80 mm.
constexpr double least_spacing_mm = 0.05;

// Radials that stop while their neighbours are nearer than this, two units of the lattice, are left out: rounding could put
// them on the wrong side of one another. At M = 100 that is within 0.03 mm of the impact.
constexpr double least_order_mm = 0.002;

// Shorter steps are gathered into one piece of a polyline.
constexpr double least_piece_mm = 0.02;

// No crack gets longer than this many diagonals of the pane's box; one that has wound about for so long ends open.
constexpr double most_diagonals = 10.0;

struct Tip {
  int crack = 0;
  CrackKind kind = CrackKind::radial;
  Id id;
  vec2 at_mm{0.0, 0.0};
  vec2 heading{1.0, 0.0};  // of unit length
  double speed_mm = 0.0;   // per unit of time
  double age = 0.0;
  double straight_mm = 0.0;  // it goes straight for as long as it is nearer than this to its start
  double length_mm = 0.0;
  std::uint32_t steps = 0;
  vec2 start_mm{0.0, 0.0};
  std::optional<Ring> ring;
};

// A starting point of a ring crack whose time has not come.
struct RingStart {
  int index = 0;
  Angle direction;
  double radius_mm = 0.0;
};

struct ImpactState {
  int index = 0;
  Id id;
  vec2 at_mm{0.0, 0.0};
  ImpactCounts counts;
  std::vector<RingStart> waiting;
  std::vector<Tip> tips;  // that grow
};

// Where large or ring cracks would need more steps than this to cross the pane once, the scene is refused. At the paper's
// speeds and dt = 0.25 that is a pane of more than 3 km.
constexpr double most_steps_across = 1e6;

class PaneGrowth {
 public:
  PaneGrowth(const Pane& pane, std::uint64_t seed);
  void strike(int impact);
  CrackNetwork network() const { return {counts_, map_.cracks()}; }

 private:
  ImpactState initial_state(int impact);
  void start_radials(ImpactState& state);
  void start_rings(ImpactState& state);
  void start_arms(ImpactState& state, const RingStart& start);
  bool is_over(const ImpactState& state) const;
  void step(ImpactState& state);
  void steer(Tip& tip, std::span<const vec2> tips_mm, const geometry::PointIndex& places) const;
  Sight sight(const Tip& tip, const Sector& sector, std::span<const vec2> tips_mm, const geometry::PointIndex& places) const;
  void advance(Tip& tip, const ImpactState& state);
  void extend(const Tip& tip, const ImpactState& state);
  geometry::Polygon piece(const Tip& tip);
  std::vector<const Tip*> growing_within(const geometry::Polygon& region, const ImpactState& state) const;
  void settle(const ImpactState& state);

  const Pane& pane_;
  const Growth& growth_;
  std::uint64_t seed_;
  double longest_mm_;
  CrackMap map_;
  // For F2, which need not know of vertices that were inserted later: the edge; ring cracks and all of earlier impacts; the
  // radials of the present impact.
  SegmentIndex edge_;
  SegmentIndex cracks_;
  SegmentIndex siblings_;
  std::vector<ImpactCounts> counts_;
};

double diagonal(const geometry::Polygon& outline) {
  const geometry::Box box = geometry::bounding_box(outline);
  return glm::length(box.high - box.low);
}

// Cells of the indexes for F2: a few across the sector.
double wide_cell(const Growth& growth) { return growth.sector_radius * px_mm / 4.0; }

PaneGrowth::PaneGrowth(const Pane& pane, std::uint64_t seed)
    : pane_(pane),
      growth_(pane.growth),
      seed_(seed),
      longest_mm_(most_diagonals * diagonal(pane.outline_mm)),
      map_(pane.outline_mm, 5.0 * px_mm),
      edge_(wide_cell(pane.growth)),
      cracks_(wide_cell(pane.growth)),
      siblings_(wide_cell(pane.growth)) {
  for (std::size_t i = 0; i < pane.outline_mm.size(); ++i) {
    edge_.add(
        {geometry::to_lattice(pane.outline_mm[i]), geometry::to_lattice(pane.outline_mm[(i + 1) % pane.outline_mm.size()]), 0});
  }
}

ImpactState PaneGrowth::initial_state(int impact) {
  const Impact& cause = pane_.impacts[static_cast<std::size_t>(impact)];
  ImpactState state;
  state.index = impact;
  state.id = Id(pane_.name).child("impact").child(static_cast<std::uint64_t>(impact));
  state.at_mm = geometry::on_lattice(cause.at_mm);
  state.counts = drawn_counts(cause, growth_, seed_, state.id);
  counts_.push_back(state.counts);
  // Eq. 4, 7, 8.
  const int r = state.counts.circular_count;
  const double mean_mm = growth_.ring_radius_slope_mm * state.counts.radial_count + growth_.ring_radius_offset_mm;
  const Id rings = state.id.child("ring");
  const double phase = uniform(seed_, {Stream::first_direction, rings});
  for (int i = 0; i < r; ++i) {
    const Id ring = rings.child(static_cast<std::uint64_t>(i));
    state.waiting.push_back(
        {i, Angle::radians(2.0 * pi * (phase + i) / r), spread_about(mean_mm, growth_, seed_, {Stream::ring_radius, ring})});
  }
  return state;
}

// All M radials, at equal angles from a random first one, N large ones spread evenly among them (eq. 9, 10, Fig. 11).
void PaneGrowth::start_radials(ImpactState& state) {
  const int m = state.counts.radial_count;
  const int n = state.counts.large_count;
  const Id radials = state.id.child("radial");
  const double first = uniform(seed_, {Stream::first_direction, radials});
  const double offset = uniform(seed_, {Stream::large_choice, radials});
  std::vector<bool> is_large(static_cast<std::size_t>(m), false);
  for (int i = 0; i < n; ++i) is_large[static_cast<std::size_t>((i + offset) * m / n) % static_cast<std::size_t>(m)] = true;
  const CrackMap::Hub hub = map_.add_hub(geometry::to_lattice(state.at_mm));
  for (int k = 0; k < m; ++k) {
    const bool large = is_large[static_cast<std::size_t>(k)];
    Tip tip;
    tip.kind = large ? CrackKind::large : CrackKind::radial;
    tip.id = radials.child(static_cast<std::uint64_t>(k));
    tip.crack = map_.start(hub, tip.kind, state.index, CrackEnd::At::impact);
    tip.at_mm = tip.start_mm = state.at_mm;
    tip.heading = Angle::radians(2.0 * pi * (first + k) / m).direction();
    tip.speed_mm = px_mm * (large ? spread_about(growth_.large_speed, growth_, seed_, {Stream::large_speed, tip.id})
                                  : spread_about(growth_.radial_speed, growth_, seed_, {Stream::radial_speed, tip.id}));
    tip.straight_mm = least_spacing_mm * m / (2.0 * pi);
    state.tips.push_back(tip);
  }
}

// The ring cracks whose time has come.
void PaneGrowth::start_rings(ImpactState& state) {
  double hindmost_mm = std::numeric_limits<double>::infinity();
  for (const Tip& tip : state.tips) {
    if (tip.kind == CrackKind::large) hindmost_mm = std::min(hindmost_mm, glm::length(tip.at_mm - state.at_mm));
  }
  std::vector<RingStart> waiting;
  for (const RingStart& start : state.waiting) {
    if (growth_.ring_onset * start.radius_mm <= hindmost_mm) {
      start_arms(state, start);
    } else {
      waiting.push_back(start);
    }
  }
  state.waiting = std::move(waiting);
}

// Eq. 11, Fig. 12: two cracks, one each way round, at one speed.
void PaneGrowth::start_arms(ImpactState& state, const RingStart& start) {
  const LatticePoint at = geometry::to_lattice(state.at_mm + start.radius_mm * start.direction.direction());
  if (!geometry::contains(pane_.outline_mm, geometry::to_mm(at)) || map_.is_taken(at) ||
      map_.is_barred(geometry::to_lattice(state.at_mm), at, state.index)) {
    return;
  }
  const CrackMap::Hub hub = map_.add_hub(at);
  const Id ring = state.id.child("ring").child(static_cast<std::uint64_t>(start.index));
  const double speed = spread_about(growth_.circular_speed, growth_, seed_, {Stream::ring_speed, ring});
  for (const bool counter_clockwise : {true, false}) {
    Tip tip;
    tip.kind = CrackKind::circular;
    tip.id = ring.child(counter_clockwise ? 0 : 1);
    tip.crack = map_.start(hub, tip.kind, state.index, CrackEnd::At::ring);
    tip.at_mm = tip.start_mm = geometry::to_mm(at);
    tip.ring = Ring{state.at_mm, start.radius_mm, counter_clockwise};
    tip.heading = direction_along(*tip.ring, tip.at_mm);
    tip.speed_mm = px_mm * speed;
    state.tips.push_back(tip);
  }
}

// "Growth ends when all large and ring cracks have stopped" (§4.3). Where an impact has neither, its radials grow until they
// have stopped.
bool PaneGrowth::is_over(const ImpactState& state) const {
  if (!state.waiting.empty()) return false;
  const bool radials_only = state.counts.large_count == 0 && state.counts.circular_count == 0;
  return std::ranges::none_of(state.tips, [&](const Tip& tip) { return radials_only || tip.kind != CrackKind::radial; });
}

Sight PaneGrowth::sight(const Tip& tip, const Sector& sector, std::span<const vec2> tips_mm,
                        const geometry::PointIndex& places) const {
  const auto wall = [&](const SegmentIndex& index, int owner) -> std::optional<Wall> {
    const std::optional<SegmentIndex::Nearest> nearest = index.nearest_in(sector, owner);
    if (!nearest) return std::nullopt;
    const geometry::Segment& segment = index.segment(nearest->number);
    const vec2 across = glm::normalize(left_of(geometry::to_mm(segment.b) - geometry::to_mm(segment.a)));
    const double side = glm::dot(across, nearest->point_mm - tip.at_mm);
    return Wall{side < 0.0 ? -across : across, nearest->distance_mm};
  };
  Sight seen;
  if (growth_.tip_gain > 0.0) {
    for (const int place : places.nearest_in(sector, nearest_tips)) {
      seen.tips_mm.push_back(tips_mm[static_cast<std::size_t>(place)] - tip.at_mm);
    }
  }
  seen.edge = wall(edge_, -1);
  seen.crack = wall(cracks_, tip.crack);
  if (tip.kind == CrackKind::circular) {
    const std::optional<Wall> radial = wall(siblings_, tip.crack);
    if (radial && (!seen.crack || radial->distance_mm < seen.crack->distance_mm)) seen.crack = radial;
  } else if (growth_.sibling_gain != 0.0) {
    seen.sibling = wall(siblings_, tip.crack);
  }
  return seen;
}

// Eq. 12 to 16. To follow its circle is no turn for a ring crack: it bends with it whatever its age.
void PaneGrowth::steer(Tip& tip, std::span<const vec2> tips_mm, const geometry::PointIndex& places) const {
  const double way_mm = tip.speed_mm * growth_.time_step;
  if (tip.ring) tip.heading = bent_along(*tip.ring, tip.heading, way_mm);
  const Sector sector(tip.at_mm, tip.heading, growth_.sector_angle, growth_.sector_radius * px_mm);
  const double deviate = normal(seed_, {Stream::turn, tip.id, tip.steps});
  const vec2 drive = tip.ring ? growth_.ring_pull * direction_along(*tip.ring, tip.at_mm)
                              : growth_.radial_pull * glm::normalize(tip.at_mm - tip.start_mm);
  const vec2 force = force_of(sight(tip, sector, tips_mm, places), growth_) +
                     wandering_force(tip.heading, deviate, way_mm / px_mm, growth_) + drive;
  tip.heading = glm::normalize(rotated(tip.heading, turn(force, tip.heading, tip.age, way_mm / px_mm, growth_)));
}

// Eq. 17, and the stop rules of §4.2.3.
void PaneGrowth::advance(Tip& tip, const ImpactState& state) {
  const double way_mm = tip.speed_mm * growth_.time_step;
  tip.at_mm += way_mm * tip.heading;
  tip.length_mm += way_mm;
  tip.age += growth_.time_step;
  ++tip.steps;
  const bool is_piece = glm::length(tip.at_mm - geometry::to_mm(map_.tip(tip.crack))) >= least_piece_mm;
  if (is_piece && glm::length(tip.at_mm - tip.start_mm) >= tip.straight_mm) extend(tip, state);
  if (tip.length_mm > longest_mm_ && map_.is_growing(tip.crack)) map_.stop(tip.crack, CrackEnd::At::open);
}

// Leads the crack to where its tip is by now, if nothing is in the way. Where that closes a region, every tip inside it stops
// (§4.2.3 (2)).
void PaneGrowth::extend(const Tip& tip, const ImpactState& state) {
  std::vector<geometry::Polygon> regions = {piece(tip)};  // an empty one has no inside
  while (!regions.empty()) {
    const geometry::Polygon region = std::move(regions.back());
    regions.pop_back();
    for (const Tip* inside : growing_within(region, state)) {
      if (!map_.is_growing(inside->crack)) continue;  // met by one of the others
      // What the tip has gone since its last vertex still belongs to it, and may close another region.
      geometry::Polygon next = piece(*inside);
      if (!next.empty()) regions.push_back(std::move(next));
      if (map_.is_growing(inside->crack)) map_.stop(inside->crack, CrackEnd::At::enclosed);
    }
  }
}

// Adds the way from the last vertex of the crack to its tip. Returns the region that this closed; empty if none.
geometry::Polygon PaneGrowth::piece(const Tip& tip) {
  if (glm::length(tip.at_mm - tip.start_mm) < tip.straight_mm * (least_order_mm / least_spacing_mm)) return {};
  const LatticePoint from = map_.tip(tip.crack);
  const std::optional<Arrest> arrest = map_.extend(tip.crack, geometry::to_lattice(tip.at_mm));
  const LatticePoint to = map_.tip(tip.crack);
  if (to != from) (tip.kind == CrackKind::circular ? cracks_ : siblings_).add({from, to, tip.crack});
  if (!arrest) return {};
  geometry::Polygon region(arrest->closed_region.size());
  std::ranges::transform(arrest->closed_region, region.begin(), [](LatticePoint p) { return geometry::to_mm(p); });
  return region;
}

// Tips lie between the points of the lattice, and one may be less than 1 µm from its impact, where regions meet: so both are
// taken to a finer lattice, and one that has not gone yet is looked for in front of its start.
std::vector<const Tip*> PaneGrowth::growing_within(const geometry::Polygon& region, const ImpactState& state) const {
  if (region.empty()) return {};
  constexpr double finer = 1000.0;
  geometry::Polygon fine_region = region;
  for (vec2& vertex : fine_region) vertex *= finer;
  const geometry::Box box = geometry::bounding_box(region);
  std::vector<const Tip*> found;
  for (const Tip& tip : state.tips) {
    const vec2 at = tip.length_mm > 0.0 ? tip.at_mm : tip.at_mm + least_piece_mm * tip.heading;
    const bool near = glm::all(glm::greaterThan(at, box.low)) && glm::all(glm::lessThan(at, box.high));
    if (!near || tip.kind == CrackKind::circular || !map_.is_growing(tip.crack)) continue;
    if (geometry::contains(fine_region, finer * at)) found.push_back(&tip);
  }
  return found;
}

void PaneGrowth::step(ImpactState& state) {
  start_rings(state);
  std::vector<vec2> tips_mm(state.tips.size());
  std::ranges::transform(state.tips, tips_mm.begin(), [](const Tip& tip) { return tip.at_mm; });
  const geometry::PointIndex places(tips_mm);
  // All tips turn by what stands at this moment, then they go on one after the other, and meet what stands by then.
  for (Tip& tip : state.tips) {
    const bool free_to_turn = tip.age > 0.0 && glm::length(tip.at_mm - tip.start_mm) >= tip.straight_mm;
    if (free_to_turn) steer(tip, tips_mm, places);
  }
  for (Tip& tip : state.tips) {
    if (map_.is_growing(tip.crack)) advance(tip, state);
  }
  std::erase_if(state.tips, [this](const Tip& tip) { return !map_.is_growing(tip.crack); });
}

// Ends what still grows, and makes the cracks of this impact obstacles for the next.
void PaneGrowth::settle(const ImpactState& state) {
  for (const Tip& tip : state.tips) {
    if (map_.is_growing(tip.crack)) extend(tip, state);
  }
  for (const Tip& tip : state.tips) {
    if (map_.is_growing(tip.crack)) map_.stop(tip.crack, CrackEnd::At::open);
  }
  cracks_.add_all(siblings_);
  siblings_ = SegmentIndex(wide_cell(growth_));
}

void PaneGrowth::strike(int impact) {
  ImpactState state = initial_state(impact);
  start_radials(state);
  while (!is_over(state)) step(state);
  settle(state);
}

bool strictly_inside(const geometry::Polygon& outline, vec2 point) {
  const LatticePoint p = geometry::to_lattice(point);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const vec2 next = outline[(i + 1) % outline.size()];
    if (geometry::on_segment(geometry::to_lattice(outline[i]), geometry::to_lattice(next), p)) return false;
  }
  return geometry::contains(outline, point);
}

void check(const Pane& pane) {
  const Growth& growth = pane.growth;
  const double slowest_px = std::min(growth.large_speed, growth.circular_speed) * (1.0 - growth.spread_limit);
  const double step_mm = slowest_px * growth.time_step * px_mm;
  if (!(diagonal(pane.outline_mm) <= most_steps_across * step_mm)) {
    throw InputError(Place{"", 0, 0, pane.name + ".growth"},
                     "expected cracks that cross the pane in at most 1,000,000 steps: speed or time step "
                     "is too small for its size");
  }
  for (std::size_t i = 0; i < pane.impacts.size(); ++i) {
    const vec2 at = pane.impacts[i].at_mm;
    if (strictly_inside(pane.outline_mm, at)) continue;
    throw InputError(Place{"", 0, 0, fmt::format("{}.impact[{}].at_mm", pane.name, i)},
                     fmt::format("expected a point inside the outline, got ({}, {})", at.x, at.y));
  }
}

}  // namespace

CrackNetwork grown_cracks(const Pane& pane, std::uint64_t seed) {
  check(pane);
  PaneGrowth growth(pane, seed);
  for (int i = 0; i < static_cast<int>(pane.impacts.size()); ++i) growth.strike(i);
  return growth.network();
}

}  // namespace shatterpave::glass
