#include "glass/growth/printed_law.h"

#include <algorithm>
#include <cmath>

#include "core/functions.h"
#include "geometry/convex_region.h"
#include "glass/growth/crack_front.h"
#include "glass/growth/steering.h"
#include "glass/growth/tip.h"

namespace shatterpave::glass {

namespace {

using geometry::ConvexRegion;
using geometry::ConvexShape;

ConvexShape shape_of(const Growth& growth) {
  switch (growth.region) {
    case LocalRegion::sector:
      break;
    case LocalRegion::rectangle:
      return ConvexShape::rectangle(growth.rectangle_length * px_mm, growth.rectangle_width * px_mm);
    case LocalRegion::circle:
      return ConvexShape::circle(growth.circle_radius * px_mm);
  }
  return ConvexShape::sector(growth.sector_angle, growth.sector_radius * px_mm);
}

// Part of a crack, or of the edge, in a region.
struct Seen {
  int owner = 0;
  int segment = 0;
  vec2 point_mm{0.0, 0.0};
  double distance2 = 0.0;

  // Of what one owner has, the nearest first.
  bool operator<(const Seen& other) const {
    if (owner != other.owner) return owner < other.owner;
    return distance2 != other.distance2 ? distance2 < other.distance2 : segment < other.segment;
  }
};

class PrintedGrowth {
 public:
  PrintedGrowth(const Pane& pane, std::uint64_t seed, CrackMap& map);
  ImpactCounts strike(int impact);

 private:
  double step_mm(const Tip& tip) const { return tip.speed_mm * growth_.time_step; }
  double first_way_mm(const Tip& tip, double least_mm) const;
  bool is_due(const Tip& tip, const ImpactState& state) const { return tip.due <= state.now + 0.5 * growth_.time_step; }
  void go_on(ImpactState& state);
  void steer(Tip& tip, const ImpactState& state);
  void move(Tip& tip, ImpactState& state);
  vec2 push_of_tips(const Tip& tip, const ConvexRegion& region, const ImpactState& state) const;
  vec2 pull_of_walls(const Tip& tip, const ConvexRegion& region);

  const Pane& pane_;
  const Growth& growth_;
  std::uint64_t seed_;
  ConvexShape shape_;
  CrackMap& map_;
  CrackFront front_;
  std::vector<Seen> seen_;  // of one tip; kept for its memory
};

PrintedGrowth::PrintedGrowth(const Pane& pane, std::uint64_t seed, CrackMap& map)
    : pane_(pane),
      growth_(pane.growth),
      seed_(seed),
      shape_(shape_of(pane.growth)),
      map_(map),
      front_(pane, seed, map, false, [this](const Tip& tip, double least_mm) { return first_way_mm(tip, least_mm); }) {}

// Whole steps.
double PrintedGrowth::first_way_mm(const Tip& tip, double least_mm) const {
  return step_mm(tip) * std::max(1.0, std::ceil(least_mm / step_mm(tip)));
}

// F1: of all growing tips in the region.
vec2 PrintedGrowth::push_of_tips(const Tip& tip, const ConvexRegion& region, const ImpactState& state) const {
  vec2 force{0.0, 0.0};
  if (growth_.tip_gain == 0.0) return force;
  state.places.visit_in(region.box(), [&](int number) {
    const vec2 other = state.places.at(number);
    // The tip itself, and those that have not left their start yet.
    if (other == tip.at_mm || !region.contains(other)) return;
    force += push_of(other - tip.at_mm, growth_.tip_gain);
  });
  return force;
}

// F2: of all cracks in the region but its own, and of the edge, each by its nearest point.
vec2 PrintedGrowth::pull_of_walls(const Tip& tip, const ConvexRegion& region) {
  seen_.clear();
  map_.visit_in(region.box(), [&](int number) {
    const geometry::Segment segment = map_.segment(number);
    if (segment.owner == tip.crack) return;
    const auto nearest = region.nearest_point(geometry::to_mm(segment.a), geometry::to_mm(segment.b));
    if (!nearest) return;
    const vec2 offset = *nearest - tip.at_mm;
    seen_.push_back({segment.owner, number, *nearest, glm::dot(offset, offset)});
  });
  std::sort(seen_.begin(), seen_.end());
  vec2 force{0.0, 0.0};
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    if (i > 0 && seen_[i].owner == seen_[i - 1].owner) continue;
    const double gain = seen_[i].owner == CrackMap::edge_owner ? growth_.edge_gain : growth_.crack_gain;
    force += pull_of(wall_at(seen_[i].point_mm, map_.segment(seen_[i].segment), tip.at_mm), gain);
  }
  return force;
}

// Eq. 12 to 16. To follow its circle is no turn for a ring crack: it bends with it whatever its age.
void PrintedGrowth::steer(Tip& tip, const ImpactState& state) {
  if (tip.ring) tip.heading = bent_along(*tip.ring, tip.heading, tip.way_mm);
  const ConvexRegion region(tip.at_mm, tip.heading, shape_);
  const double deviate = normal(seed_, {Stream::turn, tip.id, tip.steps});
  vec2 force = push_of_tips(tip, region, state) + pull_of_walls(tip, region) + turned(tip.heading, growth_.wander * deviate);
  if (tip.ring) force += growth_.ring_pull * direction_along(*tip.ring, tip.at_mm);
  tip.heading = glm::normalize(turned(tip.heading, turn_towards(force, tip.heading, 1.0 - tip.inertia, growth_)));
}

// Eq. 17, and the stop rules of §4.2.3.
void PrintedGrowth::move(Tip& tip, ImpactState& state) {
  const double way_mm = tip.way_mm;
  tip.at_mm += way_mm * tip.heading;
  tip.length_mm += way_mm;
  tip.inertia *= inertia(way_mm / tip.speed_mm, growth_);
  tip.way_mm = step_mm(tip);
  tip.due = state.now + growth_.time_step;
  ++tip.steps;
  front_.extend(tip, tip.at_mm, state.now, state);
  front_.stop_too_long(tip);
}

// All tips turn by what is there at one time, before any goes on.
void PrintedGrowth::go_on(ImpactState& state) {
  for (const int number : state.growing) {
    Tip& tip = state.tips[static_cast<std::size_t>(number)];
    // The first step goes straight: eq. 19 is 0 at its start.
    if (tip.steps > 0) steer(tip, state);
  }
  state.now += growth_.time_step;
  for (const int number : state.growing) {
    Tip& tip = state.tips[static_cast<std::size_t>(number)];
    if (!is_due(tip, state) || !map_.is_growing(tip.crack)) continue;
    move(tip, state);
    state.places.put(number, tip.at_mm);
  }
  front_.forget_stopped(state);
}

ImpactCounts PrintedGrowth::strike(int impact) {
  ImpactState state = initial_state(pane_, impact, seed_);
  front_.start_radials(state);
  for (const RingStart& start : state.waiting) front_.start_arms(state, start);
  state.waiting.clear();
  while (!front_.is_over(state)) go_on(state);
  front_.settle(state);
  return state.counts;
}

}  // namespace

double least_printed_step_px(const Growth& growth) {
  return (1.0 - growth.spread_limit) * growth.time_step *
         std::min({growth.large_speed, growth.radial_speed, growth.circular_speed});
}

std::vector<ImpactCounts> grow_by_printed_law(const Pane& pane, std::uint64_t seed, CrackMap& map) {
  PrintedGrowth growth(pane, seed, map);
  std::vector<ImpactCounts> counts;
  counts.reserve(pane.impacts.size());
  for (int i = 0; i < static_cast<int>(pane.impacts.size()); ++i) counts.push_back(growth.strike(i));
  return counts;
}

}  // namespace shatterpave::glass
