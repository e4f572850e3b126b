#include "glass/growth/crack_front.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/predicates.h"
#include "glass/growth/counts.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;

// Radials start straight for as long as neighbours are nearer than this: half the thinnest crack that a picture can show, and
// so many units of the lattice that rounding swaps no two of them. At M = 100 that is the first 0.8 mm, at M = 10,000 80 mm.
constexpr double least_spacing_mm = 0.05;

// Radials that stop while their neighbours are nearer than this, two units of the lattice, are left out: rounding could put
// them on the wrong side of one another. At M = 100 that is within 0.03 mm of the impact.
constexpr double least_order_mm = 0.002;

// No crack gets longer than this many diagonals of the pane's box; one that has wound about for so long ends open.
constexpr double most_diagonals = 10.0;

}  // namespace

double diagonal(const geometry::Polygon& outline) {
  const geometry::Box box = geometry::bounding_box(outline);
  return glm::length(box.high - box.low);
}

double cell_of_walls(const Growth& growth) { return 0.5 * growth.sector_radius * px_mm; }

CrackFront::CrackFront(const Pane& pane, std::uint64_t seed, CrackMap& map, bool spares_rings, FirstWay first_way)
    : pane_(pane),
      growth_(pane.growth),
      seed_(seed),
      map_(map),
      spares_rings_(spares_rings),
      first_way_(std::move(first_way)),
      longest_mm_(most_diagonals * diagonal(pane.outline_mm)),
      obstacles_(cell_of_walls(pane.growth)) {}

void CrackFront::start_radials(ImpactState& state) {
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
    tip.way_mm = first_way_(tip, least_spacing_mm * m / (2.0 * pi));
    add(state, tip);
  }
}

Tip CrackFront::radial_tip(const ImpactState& state, CrackMap::Hub hub, int number, bool large) {
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

void CrackFront::add(ImpactState& state, Tip tip) const {
  tip.due = state.now + tip.onset + tip.way_mm / tip.speed_mm;
  tip.decay = inertia(growth_.step_length * px_mm / tip.speed_mm, growth_);
  const int number = static_cast<int>(state.tips.size());
  state.places.put(number, tip.at_mm);
  state.growing.push_back(number);
  state.tips.push_back(tip);
}

void CrackFront::start_arms(ImpactState& state, const RingStart& start) {
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
    tip.way_mm = first_way_(tip, 0.0);
    add(state, tip);
  }
}

bool CrackFront::is_over(const ImpactState& state) const {
  if (!state.waiting.empty()) return false;
  const bool radials_only =
      pane_.pattern == Pattern::real || (state.counts.large_count == 0 && state.counts.circular_count == 0);
  return std::ranges::none_of(state.growing, [&](int number) {
    return radials_only || state.tips[static_cast<std::size_t>(number)].kind != CrackKind::radial;
  });
}

void CrackFront::extend(const Tip& tip, vec2 to_mm, double time, const ImpactState& state) {
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
vec2 CrackFront::place(const Tip& tip, const ImpactState& state) const {
  const double gone_mm = std::clamp(tip.way_mm - (tip.due - state.now) * tip.speed_mm, 0.0, tip.way_mm);
  const double least_mm = tip.steps == 0 ? least_order_mm * state.counts.radial_count / (2.0 * pi) : 0.0;
  return gone_mm < std::max(least_piece_mm, least_mm) ? tip.at_mm : tip.at_mm + gone_mm * tip.heading;
}

// Adds the way from the last vertex of the crack to `to_mm`. Returns the border of the region that this closed; empty if none.
CrackFront::Border CrackFront::piece(const Tip& tip, vec2 to_mm, double at_us) {
  const LatticePoint from = map_.tip(tip.crack);
  std::optional<Arrest> arrest = map_.extend(tip.crack, geometry::to_lattice(to_mm), at_us);
  const LatticePoint to = map_.tip(tip.crack);
  if (tip.ring && to != from) obstacles_.add({from, to, tip.crack});
  return arrest ? std::move(arrest->closed_region) : Border{};
}

// Radials of real panes are spared: they run on to what encloses them.
// One that has not gone yet lies on the border of whatever is closed about its impact: it is looked for in front of its start,
// on a finer lattice, since there regions are narrow.
std::vector<const Tip*> CrackFront::growing_within(const Border& border, const ImpactState& state) const {
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
    if (!near || (spares_rings_ && tip.ring) || tip.course || !map_.is_growing(tip.crack)) return;
    if (geometry::contains(region, finer * at)) found.push_back(&tip);
  });
  return found;
}

void CrackFront::forget_stopped(ImpactState& state) const {
  std::erase_if(state.growing, [&](int number) {
    const bool stopped = !map_.is_growing(state.tips[static_cast<std::size_t>(number)].crack);
    if (stopped) state.places.remove(number);
    return stopped;
  });
}

void CrackFront::settle(const ImpactState& state) {
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

void CrackFront::stop_too_long(const Tip& tip) {
  if (map_.is_growing(tip.crack) && tip.length_mm > longest_mm_) map_.stop(tip.crack, CrackEnd::At::open);
}

}  // namespace shatterpave::glass
