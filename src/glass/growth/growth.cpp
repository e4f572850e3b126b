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
#include "glass/growth/crack_front.h"
#include "glass/growth/printed_law.h"
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

// In strips narrower than this radials of real panes hardly turn, since tension round the impact drives them all outwards. By
// eye.
constexpr double free_strip_mm = 6.0;

// A crack needs this way to become so fast that it branches. By eye.
constexpr double least_branching_mm = 12.0;
// By which share of the angle between them a branch and the crack that it leaves turn. By eye.
constexpr double branch_turn = 0.6;

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
  void start_real_radials(ImpactState& state);
  void start_rings(ImpactState& state);
  void go_on(ImpactState& state);
  void step(Tip& tip, ImpactState& state);
  void branch(Tip& tip, double way_mm, ImpactState& state);
  void steer(Tip& tip, const ImpactState& state) const;
  vec2 force_on(const Tip& tip, const Sector& sector, const ImpactState& state) const;
  std::optional<Wall> crack_before(const Tip& tip, const Sector& sector) const;
  void lay_rings(ImpactState& state);

  const Pane& pane_;
  const Growth& growth_;
  std::uint64_t seed_;
  double step_mm_;
  geometry::SectorShape sight_;
  CrackMap& map_;
  CrackFront front_;
  SegmentIndex edge_;  // for F2 on radials, with wider cells than those of the map
};

PaneGrowth::PaneGrowth(const Pane& pane, std::uint64_t seed, CrackMap& map)
    : pane_(pane),
      growth_(pane.growth),
      seed_(seed),
      step_mm_(pane.growth.step_length * px_mm),
      sight_(pane.growth.sector_angle, pane.growth.sector_radius * px_mm),
      map_(map),
      front_(pane, seed, map, true, [this](const Tip&, double least_mm) { return std::max(step_mm_, least_mm); }),
      edge_(cell_of_walls(pane.growth)) {
  for (std::size_t i = 0; i < pane.outline_mm.size(); ++i) {
    edge_.add(
        {geometry::to_lattice(pane.outline_mm[i]), geometry::to_lattice(pane.outline_mm[(i + 1) % pane.outline_mm.size()]), 0});
  }
}

// Those of real panes.
void PaneGrowth::start_real_radials(ImpactState& state) {
  const double first_mm = first_real_step_mm(state.counts.radial_count);
  std::vector<RadialCourse> courses = courses_of(pane_, state, seed_, first_mm);
  const CrackMap::Hub hub = map_.add_hub(geometry::to_lattice(state.at_mm));
  for (int k = 0; k < state.counts.radial_count; ++k) {
    RadialCourse& course = courses[static_cast<std::size_t>(k)];
    Tip tip = front_.radial_tip(state, hub, k, course.large);
    tip.speed_mm *= course.speed_share;
    tip.heading = course.direction.direction();
    tip.way_mm = first_mm;
    tip.course = std::move(course);
    front_.add(state, tip);
  }
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
      front_.start_arms(state, start);
    } else {
      waiting.push_back(start);
    }
  }
  state.waiting = std::move(waiting);
}

// The crack of F2: for a ring crack the nearest of all, for a radial the nearest but those of its own impact's radials.
std::optional<Wall> PaneGrowth::crack_before(const Tip& tip, const Sector& sector) const {
  if (!tip.ring) {
    const auto nearest = front_.obstacles().nearest_in(sector, [](const geometry::Segment&) { return true; });
    return nearest ? std::optional(wall_at(nearest->point_mm, front_.obstacles().segment(nearest->number), tip.at_mm))
                   : std::nullopt;
  }
  const auto nearest = map_.nearest_in(sector, [&](int crack) { return crack != tip.crack; });
  return nearest ? std::optional(wall_at(nearest->point_mm, map_.segment(nearest->number), tip.at_mm)) : std::nullopt;
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
  if (edge) seen.edge = wall_at(edge->point_mm, edge_.segment(edge->number), tip.at_mm);
  seen.crack = crack_before(tip, sector);
  if (!tip.ring && growth_.sibling_gain != 0.0) {
    const auto sibling = map_.nearest_in(sector, [&](int crack) {
      return crack != tip.crack && map_.impact(crack) == state.index && map_.kind(crack) != CrackKind::circular;
    });
    if (sibling) seen.sibling = wall_at(sibling->point_mm, map_.segment(sibling->number), tip.at_mm);
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
  front_.extend(tip, tip.at_mm, done, state);
  front_.stop_too_long(tip);
  if (!map_.is_growing(tip.crack)) return;
  const bool arrests = tip.veered && tip.course->arrests;
  if (arrests)
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
  fresh.crack =
      map_.start(map_.add_hub(at), fresh.kind, state.index, CrackEnd::At::crack, front_.time_us(state.index, state.now));
  fresh.at_mm = fresh.start_mm = geometry::to_mm(at);
  fresh.heading = turned(tip.heading, side * branch_turn * angle);
  fresh.speed_mm = tip.speed_mm;
  fresh.way_mm = step_mm_;
  state.branches.push_back(fresh);
  tip.heading = turned(tip.heading, side * (branch_turn - 1.0) * angle);
  tip.straight = true;
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
  for (const Tip& fresh : state.branches) front_.add(state, fresh);
  state.branches.clear();
  front_.forget_stopped(state);
}

// In place of ring cracks that grow: pieces from radial to radial.
void PaneGrowth::lay_rings(ImpactState& state) {
  std::vector<int> radials;
  for (const Tip& tip : state.tips) radials.push_back(tip.crack);
  const std::vector<int> arms = lay_ring_pieces(pane_, {state.index, state.id, state.at_mm}, radials, seed_, map_);
  for (const int arm : arms) {
    for (const int piece : map_.pieces(arm)) front_.add_obstacle(map_.segment(piece));
  }
  lay_chips(radials, {state.index, state.id, state.at_mm}, ring_speed_mm_us(growth_), seed_, map_);
  state.counts.circular_count = static_cast<int>(arms.size() / 2);
}

ImpactCounts PaneGrowth::strike(int impact) {
  ImpactState state = initial_state(pane_, impact, seed_);
  if (pane_.pattern == Pattern::real) {
    start_real_radials(state);
  } else {
    front_.start_radials(state);
  }
  while (!front_.is_over(state)) go_on(state);
  front_.settle(state);
  if (pane_.pattern == Pattern::real) lay_rings(state);
  return state.counts;
}

// What only growth needs is given back before the network is made, which then takes little memory that is new.
std::vector<ImpactCounts> grow(const Pane& pane, std::uint64_t seed, CrackMap& map) {
  if (pane.growth.law == GrowthLaw::printed && pane.pattern != Pattern::real) return grow_by_printed_law(pane, seed, map);
  PaneGrowth growth(pane, seed, map);
  std::vector<ImpactCounts> counts;
  counts.reserve(pane.impacts.size());
  for (int i = 0; i < static_cast<int>(pane.impacts.size()); ++i) counts.push_back(growth.strike(i));
  return counts;
}

}  // namespace

void require_few_steps(const Pane& pane) {
  const bool printed = pane.growth.law == GrowthLaw::printed && pane.pattern != Pattern::real;
  const double step_px = printed ? least_printed_step_px(pane.growth) : pane.growth.step_length;
  if (!(diagonal(pane.outline_mm) <= most_steps_across * step_px * px_mm)) {
    throw InputError(Place{"", 0, 0, pane.name + ".growth"},
                     "expected cracks that cross the pane in at most 1,000,000 steps: the step is too short for its size");
  }
}

CrackNetwork grown_cracks(const Pane& pane, std::uint64_t seed) {
  CrackMap map(pane.outline_mm, narrow_cell_mm, pane.growth.enclosed_tips_stop);
  std::vector<ImpactCounts> counts = grow(pane, seed, map);
  return {std::move(counts), map.cracks(pane.time_us.has_value())};
}

}  // namespace shatterpave::glass
