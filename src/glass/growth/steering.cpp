#include "glass/growth/steering.h"

#include <algorithm>
#include <cmath>

#include "core/functions.h"

namespace shatterpave::glass {

namespace {

// A ring crack that has left its circle by this much heads back at 45°; by eye: much less and it zigzags about its circle, much
// more and it is slow to come back.
constexpr double return_distance_mm = 15.0 * px_mm;

// Nearer than this the force of a crack or an edge grows no more: it decides the direction long before, and must stay finite.
constexpr double nearest_distance_px = 0.1;

double inverse_square(double distance_mm) {
  const double distance = std::max(distance_mm / px_mm, nearest_distance_px);
  return 1.0 / (distance * distance);
}

vec2 pull(const std::optional<Wall>& wall, double gain) { return wall ? pull_of(*wall, gain) : vec2{0.0, 0.0}; }

}  // namespace

Wall wall_at(vec2 nearest_mm, const geometry::Segment& segment, vec2 from) {
  const vec2 across = glm::normalize(left_of(geometry::to_mm(segment.b) - geometry::to_mm(segment.a)));
  return {glm::dot(across, nearest_mm - from) < 0.0 ? -across : across, glm::length(nearest_mm - from)};
}

vec2 pull_of(const Wall& wall, double gain) { return gain * inverse_square(wall.distance_mm) * wall.towards; }

vec2 push_of(vec2 offset_mm, double gain) {
  const double distance = glm::length(offset_mm);
  return -gain * inverse_square(distance) * (offset_mm / distance);
}

vec2 force_of(const Sight& sight, const Growth& growth) {
  vec2 force =
      pull(sight.crack, growth.crack_gain) + pull(sight.sibling, growth.sibling_gain) + pull(sight.edge, growth.edge_gain);
  for (const vec2& tip : sight.tips_mm) force += push_of(tip, growth.tip_gain);
  return force;
}

vec2 direction_along(const Ring& ring, vec2 at_mm) {
  const vec2 outwards = at_mm - ring.centre_mm;
  const double distance = glm::length(outwards);
  if (distance == 0.0) return {0.0, 0.0};
  const vec2 radial = outwards / distance;
  const vec2 tangent = ring.counter_clockwise ? left_of(radial) : -left_of(radial);
  return glm::normalize(tangent + radial * ((ring.radius_mm - distance) / return_distance_mm));
}

double inertia(double age, const Growth& growth) { return exponential(-age / growth.weight_time); }

Angle turn_towards(vec2 force, vec2 heading, double weight, const Growth& growth) {
  const Angle difference = Angle::radians(arctangent(cross(heading, force), glm::dot(heading, force)));
  return std::clamp(difference, -growth.turn_limit, growth.turn_limit) * weight;
}

Angle turn(vec2 force, vec2 heading, double weight, double step_px, const Growth& growth) {
  const double share = std::min(1.0, step_px / growth.turn_length);
  return turn_towards(force, heading, weight * share, growth);
}

vec2 turned(vec2 v, Angle angle) {
  const SineAndCosine turn = sine_and_cosine(angle.radians());
  return turn.cosine * v + turn.sine * left_of(v);
}

vec2 wandering_force(vec2 heading, double deviate, double step_px, const Growth& growth) {
  // The turns of n steps add up to sqrt(n) of one, and turn() takes the n-th part of each.
  const double steps = std::max(1.0, growth.turn_length / step_px);
  return turned(heading, growth.wander * (std::sqrt(steps) * deviate));
}

vec2 bent_along(const Ring& ring, vec2 heading, double way_mm) {
  const Angle bend = Angle::radians(way_mm / ring.radius_mm);
  return turned(heading, ring.counter_clockwise ? bend : -bend);
}

}  // namespace shatterpave::glass
