// The model in outline. An impact gets its counts (eq. 3, 5, 6), its radials, at equal angles, and the starting points of its
// ring cracks. Then every tip goes on in steps of one length, each when its time has come: it looks into the sector in front of
// it, turns by the forces of what it sees there, and goes on, until all large and ring cracks have stopped.
//
// Departures from the paper, most by a parameter of Growth:
// - a step is so long, not so short a time (step_length), and a tip turns by its length, not by its steps (turn_length);
// - ring cracks start when the large cracks are out of their way (ring_onset);
// - a pull along its circle keeps a ring crack on it (ring_pull), where the paper states the rule without a formula;
// - a weak pull keeps radials on their way out, however large the pane is (radial_pull);
// - F2 between radials of one impact has a gain of its own (sibling_gain);
// - the second stop rule spares ring cracks: stopped in the middle of a region they would float in the glass, touching nothing.
// Beyond the paper, and none by default: radials that start late (radial_onset), branches (branch_rate_per_m), radials that die
// on their way and rings of pieces in place of growing ones (Pattern::real). In F1 only the nearest tips count (nearest_tips),
// in F2 only the nearest crack: with the square of the distance in the denominator the rest hardly shows, and where radials
// crowd about the impact all pairs would be too many.
#include "glass/growth/growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "geometry/predicates.h"
#include "glass/growth/counts.h"
#include "glass/growth/crack_chips.h"
#include "glass/growth/real_radials.h"
#include "glass/growth/ring_pieces.h"
#include "glass/growth/steering.h"
#include "glass/growth/tip.h"
#include "glass/map/crack_map.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;
using geometry::Sector;
using geometry::SegmentIndex;

// Tips that F1 looks at. By eye: beyond four nothing changes in a picture.
constexpr std::size_t nearest_tips = 4;

// Radials start straight for as long as neighbours are nearer than this: half the thinnest crack that a picture can show, and
// so many units of the lattice that rounding swaps no two of them. At M = 100 that is the first 0.8 mm, at M = 10,000 80 mm.
constexpr double least_spacing_mm = 0.05;

// In strips narrower than this radials of real panes hardly turn, since tension round the impact drives them all outwards. By
// eye.
constexpr double free_strip_mm = 6.0;

// Radials that stop while their neighbours are nearer than this, two units of the lattice, are left out: rounding could put
// them on the wrong side of one another. At M = 100 that is within 0.03 mm of the impact.
constexpr double least_order_mm = 0.002;

// A crack needs this way to become so fast that it branches. By eye.
constexpr double least_branching_mm = 12.0;
// By which share of the angle between them a branch and the crack that it leaves turn. By eye.
constexpr double branch_turn = 0.6;

// No crack gets longer than this many diagonals of the pane's box; one that has wound about for so long ends open.
constexpr double most_diagonals = 10.0;

// Cells of the map of cracks: about a step of growth.
constexpr double narrow_cell_mm = 9.0 * px_mm;

// Where cracks would need more steps than this to cross the pane once, the scene is refused. With steps of the length by
// default that is a pane of more than 2 km.
constexpr double most_steps_across = 1e6;

class PaneGrowth {
 public:
  // Cracks go into `map`.
  PaneGrowth(const Pane& pane, std::uint64_t seed, CrackMap& map);
  ImpactCounts strike(int impact);

 private:
  // On the pane's clock, of a time after the impact in units of the model.
  double time_us(int impact, double time) const {
    return pane_.impacts[static_cast<std::size_t>(impact)].time_us + unit_us(growth_) * time;
  }
  void start_radials(ImpactState& state);
  void start_real_radials(ImpactState& state);
  Tip radial_tip(const ImpactState& state, CrackMap::Hub hub, int number, bool large);
  void start_rings(ImpactState& state);
  void start_arms(ImpactState& state, const RingStart& start);
  void add(ImpactState& state, Tip tip) const;
  bool is_over(const ImpactState& state) const;
  void go_on(ImpactState& state);
  void forget_stopped(ImpactState& state) const;
  void step(Tip& tip, ImpactState& state);
  void branch(Tip& tip, double way_mm, ImpactState& state);
  void steer(Tip& tip, const ImpactState& state) const;
  vec2 force_on(const Tip& tip, const Sector& sector, const ImpactState& state) const;
  std::optional<Wall> crack_before(const Tip& tip, const Sector& sector) const;
  // Points of the lattice; empty where nothing is bordered.
  using Border = std::vector<LatticePoint>;
  void extend(const Tip& tip, vec2 to_mm, double time, const ImpactState& state);
  vec2 place(const Tip& tip, const ImpactState& state) const;
  Border piece(const Tip& tip, vec2 to_mm, double at_us);
  std::vector<const Tip*> growing_within(const Border& border, const ImpactState& state) const;
  void settle(const ImpactState& state);
  void lay_rings(ImpactState& state);

  const Pane& pane_;
  const Growth& growth_;
  std::uint64_t seed_;
  double step_mm_;
  double longest_mm_;
  geometry::SectorShape sight_;
  CrackMap& map_;
  // For F2 on radials, with wider cells than those of the map; it need not know of vertices that were inserted later.
  SegmentIndex edge_;
  SegmentIndex obstacles_;  // ring cracks, and all cracks of earlier impacts
};

double diagonal(const geometry::Polygon& outline) {
  const geometry::Box box = geometry::bounding_box(outline);
  return glm::length(box.high - box.low);
}

// Cells of the indexes for F2.
double cell_of_walls(const Growth& growth) { return 0.5 * growth.sector_radius * px_mm; }

PaneGrowth::PaneGrowth(const Pane& pane, std::uint64_t seed, CrackMap& map)
    : pane_(pane),
      growth_(pane.growth),
      seed_(seed),
      step_mm_(pane.growth.step_length * px_mm),
      longest_mm_(most_diagonals * diagonal(pane.outline_mm)),
      sight_(pane.growth.sector_angle, pane.growth.sector_radius * px_mm),
      map_(map),
      edge_(cell_of_walls(pane.growth)),
      obstacles_(cell_of_walls(pane.growth)) {
  for (std::size_t i = 0; i < pane.outline_mm.size(); ++i) {
    edge_.add(
        {geometry::to_lattice(pane.outline_mm[i]), geometry::to_lattice(pane.outline_mm[(i + 1) % pane.outline_mm.size()]), 0});
  }
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
  state.tips.reserve(static_cast<std::size_t>(m) + 2 * static_cast<std::size_t>(state.counts.circular_count));
  state.growing.reserve(state.tips.capacity());
  for (int k = 0; k < m; ++k) {
    Tip tip = radial_tip(state, hub, k, is_large[static_cast<std::size_t>(k)]);
    tip.heading = Angle::radians(2.0 * pi * (first + k) / m).direction();
    tip.way_mm = std::max(step_mm_, least_spacing_mm * m / (2.0 * pi));
    add(state, tip);
  }
}

// A radial that has not grown yet.
Tip PaneGrowth::radial_tip(const ImpactState& state, CrackMap::Hub hub, int number, bool large) {
  Tip tip;
  tip.kind = large ? CrackKind::large : CrackKind::radial;
  tip.id = state.id.child("radial").child(static_cast<std::uint64_t>(number));
  tip.at_mm = tip.start_mm = state.at_mm;
  tip.speed_mm = px_mm * (large ? spread_about(growth_.large_speed, growth_, seed_, {Stream::large_speed, tip.id})
                                : spread_about(growth_.radial_speed, growth_, seed_, {Stream::radial_speed, tip.id}));
  if (!large && growth_.radial_onset > 0.0) {
    tip.onset = growth_.radial_onset * uniform(seed_, {Stream::radial_onset, tip.id});
  }
  tip.crack = map_.start(hub, tip.kind, state.index, CrackEnd::At::impact, time_us(state.index, tip.onset));
  return tip;
}

// Those of real panes.
void PaneGrowth::start_real_radials(ImpactState& state) {
  const double first_mm = first_real_step_mm(state.counts.radial_count);
  std::vector<RadialCourse> courses = courses_of(pane_, state, seed_, first_mm);
  const CrackMap::Hub hub = map_.add_hub(geometry::to_lattice(state.at_mm));
  for (int k = 0; k < state.counts.radial_count; ++k) {
    RadialCourse& course = courses[static_cast<std::size_t>(k)];
    Tip tip = radial_tip(state, hub, k, course.large);
    tip.speed_mm *= course.speed_share;
    tip.heading = course.direction.direction();
    tip.way_mm = first_mm;
    tip.course = std::move(course);
    add(state, tip);
  }
}

void PaneGrowth::add(ImpactState& state, Tip tip) const {
  tip.due = state.now + tip.onset + tip.way_mm / tip.speed_mm;
  tip.decay = inertia(step_mm_ / tip.speed_mm, growth_);
  const int number = static_cast<int>(state.tips.size());
  state.places.put(number, tip.at_mm);
  state.growing.push_back(number);
  state.tips.push_back(tip);
}

// The ring cracks whose time has come.
void PaneGrowth::start_rings(ImpactState& state) {
  if (state.waiting.empty()) return;
  double hindmost_mm = std::numeric_limits<double>::infinity();
  for (const int number : state.growing) {
    const Tip& tip = state.tips[static_cast<std::size_t>(number)];
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
    tip.crack = map_.start(hub, tip.kind, state.index, CrackEnd::At::ring, time_us(state.index, state.now));
    tip.at_mm = tip.start_mm = geometry::to_mm(at);
    tip.ring = Ring{state.at_mm, start.radius_mm, counter_clockwise};
    tip.heading = direction_along(*tip.ring, tip.at_mm);
    tip.speed_mm = px_mm * speed;
    tip.way_mm = step_mm_;
    add(state, tip);
  }
}

// "Growth ends when all large and ring cracks have stopped" (§4.3). Where an impact has neither, and in real panes, its radials
// grow until they have stopped.
bool PaneGrowth::is_over(const ImpactState& state) const {
  if (!state.waiting.empty()) return false;
  const bool radials_only =
      pane_.pattern == Pattern::real || (state.counts.large_count == 0 && state.counts.circular_count == 0);
  return std::ranges::none_of(state.growing, [&](int number) {
    return radials_only || state.tips[static_cast<std::size_t>(number)].kind != CrackKind::radial;
  });
}

Wall wall_at(const SegmentIndex::Nearest& nearest, const geometry::Segment& segment, vec2 from) {
  const vec2 across = glm::normalize(left_of(geometry::to_mm(segment.b) - geometry::to_mm(segment.a)));
  return {glm::dot(across, nearest.point_mm - from) < 0.0 ? -across : across, nearest.distance_mm};
}

// The crack of F2: for a ring crack the nearest of all, for a radial the nearest but those of its own impact's radials.
std::optional<Wall> PaneGrowth::crack_before(const Tip& tip, const Sector& sector) const {
  if (!tip.ring) {
    const auto nearest = obstacles_.nearest_in(sector, [](const geometry::Segment&) { return true; });
    return nearest ? std::optional(wall_at(*nearest, obstacles_.segment(nearest->number), tip.at_mm)) : std::nullopt;
  }
  const auto nearest = map_.nearest_in(sector, [&](int crack) { return crack != tip.crack; });
  return nearest ? std::optional(wall_at(*nearest, map_.segment(nearest->number), tip.at_mm)) : std::nullopt;
}

// F1 + F2.
vec2 PaneGrowth::force_on(const Tip& tip, const Sector& sector, const ImpactState& state) const {
  Sight seen;
  std::array<geometry::PointIndex::Found, nearest_tips> found;
  std::array<vec2, nearest_tips> tips_mm;
  const std::size_t count = growth_.tip_gain != 0.0 ? state.places.nearest_in(sector, found) : 0;
  for (std::size_t i = 0; i < count; ++i) tips_mm[i] = state.places.at(found[i].number) - tip.at_mm;
  seen.tips_mm = std::span(tips_mm).first(count);
  const auto edge = edge_.nearest_in(sector, [](const geometry::Segment&) { return true; });
  if (edge) seen.edge = wall_at(*edge, edge_.segment(edge->number), tip.at_mm);
  seen.crack = crack_before(tip, sector);
  if (!tip.ring && growth_.sibling_gain != 0.0) {
    const auto sibling = map_.nearest_in(sector, [&](int crack) {
      return crack != tip.crack && map_.impact(crack) == state.index && map_.kind(crack) != CrackKind::circular;
    });
    if (sibling) seen.sibling = wall_at(*sibling, map_.segment(sibling->number), tip.at_mm);
  }
  return force_of(seen, growth_);
}

// Eq. 12 to 16. To follow its circle is no turn for a ring crack: it bends with it whatever its age.
void PaneGrowth::steer(Tip& tip, const ImpactState& state) const {
  if (tip.ring) tip.heading = bent_along(*tip.ring, tip.heading, step_mm_);
  if (tip.course) tip.heading = turned(tip.heading, Angle::radians(tip.course->sweep_per_mm * tip.way_mm));
  const double step_px = tip.course ? tip.way_mm / px_mm : growth_.step_length;
  const Sector sector(tip.at_mm, tip.heading, sight_);
  const double deviate = normal(seed_, {Stream::turn, tip.id, tip.steps});
  const vec2 drive = tip.ring ? growth_.ring_pull * direction_along(*tip.ring, tip.at_mm)
                              : growth_.radial_pull * glm::normalize(tip.at_mm - tip.start_mm);
  const vec2 force = force_on(tip, sector, state) + wandering_force(tip.heading, deviate, step_px, growth_) + drive;
  double weight = 1.0 - tip.inertia;
  if (tip.course) weight *= std::min(1.0, 2.0 * pi * tip.length_mm / (state.counts.radial_count * free_strip_mm));
  tip.heading = glm::normalize(turned(tip.heading, turn(force, tip.heading, weight, step_px, growth_)));
}

// Eq. 17, and the stop rules of §4.2.3. The first step goes straight, and so does the first after a branch.
void PaneGrowth::step(Tip& tip, ImpactState& state) {
  const bool first = tip.steps == 0;
  const double way_mm = tip.way_mm;
  if (!first && !tip.straight) steer(tip, state);
  tip.straight = false;
  tip.at_mm += way_mm * tip.heading;
  tip.length_mm += way_mm;
  tip.inertia *= first || tip.course ? inertia(way_mm / tip.speed_mm, growth_) : tip.decay;
  tip.way_mm = step_mm_;
  if (tip.course) follow_course(tip, step_mm_);
  const double done = tip.due;
  tip.due += tip.way_mm / tip.speed_mm;
  ++tip.steps;
  extend(tip, tip.at_mm, done, state);
  if (!map_.is_growing(tip.crack)) return;
  const bool arrests = tip.veered && tip.course->arrests;
  if (arrests || tip.length_mm > longest_mm_)
    map_.stop(tip.crack, CrackEnd::At::open);
  else if (growth_.branch_rate_per_m > 0.0)
    branch(tip, way_mm, state);
}

// Lets a fast crack branch at its tip, by chance. Both turn from where it went.
void PaneGrowth::branch(Tip& tip, double way_mm, ImpactState& state) {
  const bool fast = tip.kind == CrackKind::large || tip.kind == CrackKind::branch;
  if (!fast || tip.length_mm < least_branching_mm) return;
  const auto draw = [&](std::uint32_t number) { return uniform(seed_, {Stream::branch, tip.id, 3 * tip.steps + number}); };
  if (draw(0) >= growth_.branch_rate_per_m * way_mm / 1000.0) return;
  const Angle angle = growth_.least_branch_angle + draw(1) * (growth_.greatest_branch_angle - growth_.least_branch_angle);
  const double side = draw(2) < 0.5 ? 1.0 : -1.0;
  const LatticePoint at = map_.tip(tip.crack);
  Tip fresh;
  fresh.kind = CrackKind::branch;
  fresh.id = tip.id.child("branch").child(tip.steps);
  fresh.crack = map_.start(map_.add_hub(at), fresh.kind, state.index, CrackEnd::At::crack, time_us(state.index, state.now));
  fresh.at_mm = fresh.start_mm = geometry::to_mm(at);
  fresh.heading = turned(tip.heading, side * branch_turn * angle);
  fresh.speed_mm = tip.speed_mm;
  fresh.way_mm = step_mm_;
  state.branches.push_back(fresh);
  tip.heading = turned(tip.heading, side * (branch_turn - 1.0) * angle);
  tip.straight = true;
}

// Leads the crack to where its tip came to be at `time`, if nothing is in the way. Where that closes a region, every tip inside
// it stops (§4.2.3 (2)).
void PaneGrowth::extend(const Tip& tip, vec2 to_mm, double time, const ImpactState& state) {
  const double now_us = time_us(state.index, state.now);
  std::vector<Border> closed;
  if (Border border = piece(tip, to_mm, time_us(state.index, time)); !border.empty()) closed.push_back(std::move(border));
  while (!closed.empty()) {
    const Border border = std::move(closed.back());
    closed.pop_back();
    for (const Tip* inside : growing_within(border, state)) {
      if (!map_.is_growing(inside->crack)) continue;  // met by one of the others
      // What the tip has gone since its last step still belongs to it, and may close another region.
      if (Border next = piece(*inside, place(*inside, state), now_us); !next.empty()) closed.push_back(std::move(next));
      if (map_.is_growing(inside->crack)) map_.stop(inside->crack, CrackEnd::At::enclosed);
    }
  }
}

// Where the tip is between two steps.
vec2 PaneGrowth::place(const Tip& tip, const ImpactState& state) const {
  const double gone_mm = std::clamp(tip.way_mm - (tip.due - state.now) * tip.speed_mm, 0.0, tip.way_mm);
  const double least_mm = tip.steps == 0 ? least_order_mm * state.counts.radial_count / (2.0 * pi) : 0.0;
  return gone_mm < std::max(least_piece_mm, least_mm) ? tip.at_mm : tip.at_mm + gone_mm * tip.heading;
}

// Adds the way from the last vertex of the crack to `to_mm`. Returns the border of the region that this closed; empty if none.
PaneGrowth::Border PaneGrowth::piece(const Tip& tip, vec2 to_mm, double at_us) {
  const LatticePoint from = map_.tip(tip.crack);
  std::optional<Arrest> arrest = map_.extend(tip.crack, geometry::to_lattice(to_mm), at_us);
  const LatticePoint to = map_.tip(tip.crack);
  if (tip.ring && to != from) obstacles_.add({from, to, tip.crack});
  return arrest ? std::move(arrest->closed_region) : Border{};
}

// Radials of real panes are spared, too: they run on to what encloses them.
// One that has not gone yet lies on the border of whatever is closed about its impact: it is looked for in front of its start,
// on a finer lattice, since there regions are narrow.
std::vector<const Tip*> PaneGrowth::growing_within(const Border& border, const ImpactState& state) const {
  constexpr double finer = 1000.0;
  geometry::Polygon region(border.size());
  std::ranges::transform(border, region.begin(), [](LatticePoint p) { return geometry::to_mm(p); });
  const geometry::Box box = geometry::bounding_box(region);
  for (vec2& vertex : region) vertex *= finer;
  std::vector<const Tip*> found;
  state.places.visit_in(box, [&](int number) {
    const Tip& tip = state.tips[static_cast<std::size_t>(number)];
    const vec2 at = tip.steps > 0 ? geometry::to_mm(map_.tip(tip.crack)) : tip.at_mm + least_piece_mm * tip.heading;
    const bool near = glm::all(glm::greaterThan(at, box.low)) && glm::all(glm::lessThan(at, box.high));
    if (!near || tip.kind == CrackKind::circular || tip.course || !map_.is_growing(tip.crack)) return;
    if (geometry::contains(region, finer * at)) found.push_back(&tip);
  });
  return found;
}

// Goes on for as long as the fastest tip needs for a step.
void PaneGrowth::go_on(ImpactState& state) {
  start_rings(state);
  double fastest_mm = 0.0;
  for (const int number : state.growing) {
    fastest_mm = std::max(fastest_mm, state.tips[static_cast<std::size_t>(number)].speed_mm);
  }
  state.now += step_mm_ / fastest_mm;
  for (const int number : state.growing) {
    Tip& tip = state.tips[static_cast<std::size_t>(number)];
    if (tip.due > state.now || !map_.is_growing(tip.crack)) continue;
    step(tip, state);
    state.places.put(number, tip.at_mm);
  }
  for (const Tip& fresh : state.branches) add(state, fresh);
  state.branches.clear();
  forget_stopped(state);
}

void PaneGrowth::forget_stopped(ImpactState& state) const {
  std::erase_if(state.growing, [&](int number) {
    const bool stopped = !map_.is_growing(state.tips[static_cast<std::size_t>(number)].crack);
    if (stopped) state.places.remove(number);
    return stopped;
  });
}

// Ends what still grows, and makes the cracks of this impact obstacles for the next, if there is one.
void PaneGrowth::settle(const ImpactState& state) {
  const auto still_growing = [&](auto act) {
    for (const int number : state.growing) {
      const Tip& tip = state.tips[static_cast<std::size_t>(number)];
      if (map_.is_growing(tip.crack)) act(tip);
    }
  };
  still_growing([&](const Tip& tip) { extend(tip, place(tip, state), state.now, state); });
  still_growing([&](const Tip& tip) { map_.stop(tip.crack, CrackEnd::At::open); });
  if (state.index + 1 == static_cast<int>(pane_.impacts.size())) return;
  for (const Tip& tip : state.tips) {
    if (tip.ring) continue;
    for (const int piece : map_.pieces(tip.crack)) obstacles_.add(map_.segment(piece));
  }
}

// In place of ring cracks that grow: pieces from radial to radial.
void PaneGrowth::lay_rings(ImpactState& state) {
  std::vector<int> radials;
  for (const Tip& tip : state.tips) radials.push_back(tip.crack);
  const std::vector<int> arms = lay_ring_pieces(pane_, {state.index, state.id, state.at_mm}, radials, seed_, map_);
  for (const int arm : arms) {
    for (const int piece : map_.pieces(arm)) obstacles_.add(map_.segment(piece));
  }
  lay_chips(radials, {state.index, state.id, state.at_mm}, ring_speed_mm_us(growth_), seed_, map_);
  state.counts.circular_count = static_cast<int>(arms.size() / 2);
}

ImpactCounts PaneGrowth::strike(int impact) {
  ImpactState state = initial_state(pane_, impact, seed_);
  if (pane_.pattern == Pattern::real) {
    start_real_radials(state);
  } else {
    start_radials(state);
  }
  while (!is_over(state)) go_on(state);
  settle(state);
  if (pane_.pattern == Pattern::real) lay_rings(state);
  return state.counts;
}

// What only growth needs is given back before the network is made, which then takes little memory that is new.
std::vector<ImpactCounts> grow(const Pane& pane, std::uint64_t seed, CrackMap& map) {
  PaneGrowth growth(pane, seed, map);
  std::vector<ImpactCounts> counts;
  counts.reserve(pane.impacts.size());
  for (int i = 0; i < static_cast<int>(pane.impacts.size()); ++i) counts.push_back(growth.strike(i));
  return counts;
}

}  // namespace

void require_few_steps(const Pane& pane) {
  if (!(diagonal(pane.outline_mm) <= most_steps_across * pane.growth.step_length * px_mm)) {
    throw InputError(Place{"", 0, 0, pane.name + ".growth"},
                     "expected cracks that cross the pane in at most 1,000,000 steps: the step is too short for its size");
  }
}

CrackNetwork grown_cracks(const Pane& pane, std::uint64_t seed) {
  CrackMap map(pane.outline_mm, narrow_cell_mm);
  std::vector<ImpactCounts> counts = grow(pane, seed, map);
  return {std::move(counts), map.cracks(pane.time_us.has_value())};
}

}  // namespace shatterpave::glass
