#include "glass/growth/real_radials.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/functions.h"
#include "geometry/segment_distance.h"
#include "glass/growth/crater.h"

namespace shatterpave::glass {

namespace {

// Radials start straight for as long as neighbours are nearer than this, the mean of angles that are drawn: not so near that
// rounding swaps two.
constexpr double real_spacing_mm = 0.015;
// Their first step, else; and how long steps are near the impact, as a share of the distance from it. By eye.
constexpr double least_first_mm = 0.3;
constexpr double longest_near_step = 0.35;
// One that has veered and met nobody by so many times the distance at which it did so veers on, a little each step. By eye.
constexpr double late_to_meet = 1.5;
constexpr Angle further_veer = Angle::degrees(9.0);
constexpr Angle farthest_veer = Angle::degrees(80.0);

// How far the nearest and the farthest point of the outline are.
struct Room {
  double least_mm = std::numeric_limits<double>::infinity();
  double greatest_mm = 0.0;
};

Room room_about(const geometry::Polygon& outline, vec2 point) {
  Room room;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    room.least_mm =
        std::min(room.least_mm, geometry::distance_to_segment(point, outline[i], outline[(i + 1) % outline.size()]));
    room.greatest_mm = std::max(room.greatest_mm, glm::length(outline[i] - point));
  }
  return room;
}

}  // namespace

double first_real_step_mm(int radial_count) { return std::max(least_first_mm, real_spacing_mm * radial_count / (2.0 * pi)); }

std::vector<RadialCourse> courses_of(const Pane& pane, const ImpactState& state, std::uint64_t seed, double first_mm) {
  const Room room = room_about(pane.outline_mm, state.at_mm);
  const double crushed_mm = crater_of(pane.impacts[static_cast<std::size_t>(state.index)], pane).crushed_radius_mm;
  std::vector<RadialCourse> courses =
      radial_courses(pane, state.counts, seed, state.id, crushed_mm, first_mm, room.least_mm, room.greatest_mm);
  double farthest_mm = first_mm;
  for (const RadialCourse& course : courses) {
    if (!course.large) farthest_mm = std::max(farthest_mm, course.reach_mm);
  }
  for (RadialCourse& course : courses) {
    if (!course.large) course.speed_share = course.reach_mm / farthest_mm;
  }
  return courses;
}

void follow_course(Tip& tip, double step_mm) {
  const RadialCourse& course = *tip.course;
  const double out_mm = glm::length(tip.at_mm - tip.start_mm);
  while (tip.kinks_gone < course.kinks.size() && out_mm >= course.kinks[tip.kinks_gone].radius_mm - least_piece_mm) {
    tip.heading = turned(tip.heading, course.kinks[tip.kinks_gone].turn);
    ++tip.kinks_gone;
  }
  if (!tip.veered && out_mm >= course.reach_mm - least_piece_mm) {
    tip.heading = turned(glm::normalize(tip.at_mm - tip.start_mm), course.veer);
    tip.veered = true;
  }
  tip.straight = tip.veered;
  // A neighbour that bends away, or has died, is followed.
  if (tip.veered && out_mm > late_to_meet * course.reach_mm) {
    const vec2 out = (tip.at_mm - tip.start_mm) / out_mm;
    const double side = course.veer > Angle() ? 1.0 : -1.0;
    const Angle off = Angle::radians(side * arctangent(cross(out, tip.heading), glm::dot(out, tip.heading)));
    if (off < farthest_veer) tip.heading = turned(tip.heading, side * std::min(further_veer, farthest_veer - off));
  }
  tip.way_mm = std::min(step_mm, std::max(least_first_mm, longest_near_step * out_mm));
  const auto end_at = [&](double radius_mm) {
    if (radius_mm > out_mm) tip.way_mm = std::min(tip.way_mm, std::max(radius_mm - out_mm, least_piece_mm));
  };
  if (tip.kinks_gone < course.kinks.size()) end_at(course.kinks[tip.kinks_gone].radius_mm);
  if (!tip.veered) end_at(course.reach_mm);
}

}  // namespace shatterpave::glass
