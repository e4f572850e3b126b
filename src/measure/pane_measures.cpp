#include "measure/pane_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/overloaded.h"
#include "geometry/segment_distance.h"
#include "glass/dicing/dice_shape.h"
#include "measure/crossings.h"
#include "measure/experiment.h"
#include "measure/fragments.h"
#include "measure/pattern_measures.h"
#include "measure/tracking.h"

namespace shatterpave::measure {

namespace {

using glass::Crack;
using glass::CrackEnd;
using glass::CrackKind;

// The chord on which the end of a ring crack is seen, and how far beyond the mean ring narrow gaps are counted: by eye.
constexpr double ring_end_chord_mm = 1.5;
constexpr double beyond_ring_mm = 10.0;
// Gaps between radials that are narrower than this share of their mean.
constexpr double narrow_gap_share = 0.25;

struct NearestSide {
  vec2 along{1.0, 0.0};
  double distance_mm = std::numeric_limits<double>::infinity();
};

// Of equally near sides the first.
NearestSide nearest_side(vec2 point, const geometry::Polygon& outline) {
  NearestSide nearest;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const vec2 to = outline[i + 1 < outline.size() ? i + 1 : 0];
    const double distance = geometry::distance_to_segment(point, outline[i], to);
    if (distance < nearest.distance_mm) nearest = {to - outline[i], distance};
  }
  return nearest;
}

void count_end(const CrackEnd& end, EndCounts& counts) {
  switch (end.at) {
    case CrackEnd::At::edge:
      ++counts.edge;
      return;
    case CrackEnd::At::crack:
      ++counts.crack;
      return;
    case CrackEnd::At::enclosed:
      ++counts.enclosed;
      return;
    case CrackEnd::At::impact:
    case CrackEnd::At::ring:
    case CrackEnd::At::origin:
    case CrackEnd::At::open:
      ++counts.open;
      return;
  }
}

bool is_radial(CrackKind kind) { return kind == CrackKind::large || kind == CrackKind::radial; }

bool held(const CrackEnd& end, const glass::CrackNetwork& network) {
  if (end.at == CrackEnd::At::edge) return true;
  return end.at == CrackEnd::At::crack && network.cracks[static_cast<std::size_t>(*end.crack)].kind != CrackKind::circular;
}

// The two arms of a ring crack, one after the other, share their starting point, which counts once.
void add_ring_distances(const Crack& crack, bool second_arm, vec2 impact_mm, std::vector<double>& distances) {
  const std::vector<vec2> points = tracked(crack.points_mm);
  for (std::size_t i = second_arm ? 1 : 0; i < points.size(); ++i) distances.push_back(glm::length(points[i] - impact_mm));
}

void add_ring_strays(const Crack& crack, vec2 impact_mm, std::vector<double>& strays) {
  const double start_mm = glm::length(crack.points_mm.front() - impact_mm);
  if (start_mm == 0.0) return;
  const std::vector<vec2> points = tracked(crack.points_mm);
  for (std::size_t i = 1; i < points.size(); ++i) strays.push_back(glm::length(points[i] - impact_mm) / start_mm - 1.0);
}

void add_pixel_turns(const Crack& crack, vec2 origin_mm, ImpactMeasures& result) {
  for (const Angle turn : turns(at_whole_pixels(tracked(crack.points_mm), origin_mm))) {
    result.least_pixel_turn = std::min(result.least_pixel_turn, turn);
    result.greatest_pixel_turn = std::max(result.greatest_pixel_turn, turn);
  }
}

bool is_second_arm(std::span<const Crack> cracks, std::size_t i) {
  return i > 0 && cracks[i].kind == CrackKind::circular && cracks[i - 1].kind == CrackKind::circular &&
         cracks[i].impact == cracks[i - 1].impact && cracks[i].points_mm.front() == cracks[i - 1].points_mm.front();
}

void add_turns(const Crack& crack, ImpactMeasures& result) {
  const std::vector<vec2> points = tracked(crack.points_mm);
  const std::vector<Angle> more = turns(points);
  result.turns.insert(result.turns.end(), more.begin(), more.end());
  for (std::size_t i = 0; i < more.size(); ++i) {
    result.turn_distances_mm.push_back(glm::length(points[i + 1] - result.drawn.at_mm));
  }
}

std::optional<double> radial_spread(const glass::CrackNetwork& network, int impact, double room_mm) {
  const glass::ImpactCounts& drawn = network.impacts[static_cast<std::size_t>(impact)];
  const double radius = spread_radius_mm(drawn.radial_count);
  // Where the circle leaves the pane, the edge makes gaps.
  if (room_mm < radius) return std::nullopt;
  std::vector<Angle> directions = radial_directions(network, impact, radius);
  if (directions.size() < 3) return std::nullopt;
  return gap_ratio(std::move(directions));
}

// Where the crack first comes to be that far away from the centre, as a direction from it.
std::optional<Angle> direction_at(const Crack& crack, vec2 centre, double radius_mm) {
  const auto out = std::ranges::find_if(crack.points_mm, [&](vec2 p) { return glm::length(p - centre) >= radius_mm; });
  if (out == crack.points_mm.begin() || out == crack.points_mm.end()) return std::nullopt;
  return Angle::of(way_out(centre, radius_mm, *(out - 1), *out) - centre);
}

std::optional<double> variation_of_reaching_gaps(const glass::CrackNetwork& network, int impact, double room_mm) {
  const vec2 centre = network.impacts[static_cast<std::size_t>(impact)].at_mm;
  std::vector<Angle> directions;
  for (const Crack& crack : network.cracks) {
    if (crack.impact != impact || !is_radial(crack.kind) || crack.end.at != CrackEnd::At::edge) continue;
    if (const auto direction = direction_at(crack, centre, reaching_circle * room_mm)) directions.push_back(*direction);
  }
  if (directions.size() < 3) return std::nullopt;
  return gap_variation(std::move(directions));
}

void count_gaps(const glass::CrackNetwork& network, int impact, ImpactMeasures& result) {
  const double radius = narrow_gap_radius_mm(result.drawn.radial_count);
  if (result.room_mm < radius) return;
  std::vector<Angle> directions = radial_directions(network, impact, radius);
  if (directions.size() < 3) return;
  std::ranges::sort(directions);
  const double narrow = narrow_gap_share * 2.0 * pi / static_cast<double>(directions.size());
  result.gap_count = static_cast<int>(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const bool last = i + 1 == directions.size();
    const double gap = (directions[last ? 0 : i + 1] - directions[i]).radians() + (last ? 2.0 * pi : 0.0);
    if (gap < narrow) ++result.narrow_gap_count;
  }
}

void add_ring_crack(const glass::CrackNetwork& network, std::size_t i, ImpactMeasures& result) {
  const Crack& crack = network.cracks[i];
  ++result.ring_crack_count;
  if (held(crack.end, network)) ++result.held_ring_end_count;
  add_ring_distances(crack, is_second_arm(network.cracks, i), result.drawn.at_mm, result.ring_distances_mm);
  add_ring_strays(crack, result.drawn.at_mm, result.ring_strays);
  if (crack.end.at != CrackEnd::At::crack) return;
  const Crack& met = network.cracks[static_cast<std::size_t>(*crack.end.crack)];
  if (is_radial(met.kind)) result.ring_end_angles.push_back(ring_end_angle(crack, met));
}

// `origin_mm` is where the whole pixels begin on which it is tracked.
void add_crack(const glass::CrackNetwork& network, std::size_t i, const glass::Pane& pane, vec2 origin_mm,
               ImpactMeasures& of_impact) {
  const Crack& crack = network.cracks[i];
  const bool reaches_edge = crack.end.at == CrackEnd::At::edge;
  count_end(crack.end, of_impact.ends);
  if (reaches_edge) of_impact.edge_angles.push_back(edge_angle(crack, pane.outline_mm));
  if (crack.kind == CrackKind::circular) {
    add_ring_crack(network, i, of_impact);
    return;
  }
  if (is_radial(crack.kind)) add_pixel_turns(crack, origin_mm, of_impact);
  if (is_radial(crack.kind) && reaches_edge) ++of_impact.reaching_count;
  if (crack.kind == CrackKind::large) add_turns(crack, of_impact);
}

}  // namespace

bool is_young(const ImpactMeasures& measures, std::size_t i) {
  return measures.turn_distances_mm[i] <= young_turns_within * measures.room_mm;
}

bool is_grown(const ImpactMeasures& measures, std::size_t i) {
  const double distance_mm = measures.turn_distances_mm[i];
  return distance_mm >= grown_turns_from * measures.room_mm && distance_mm <= grown_turns_within * measures.room_mm;
}

Subject subject_of(const glass::Pane& pane) {
  const bool as_the_paper = pane.pattern == glass::Pattern::agui1992;
  return std::visit(
      Overloaded{[&](const glass::Annealed&) { return as_the_paper ? Subject::experiment : Subject::rings; },
                 [](const glass::Laminated&) { return Subject::rings; }, [](const glass::Tempered&) { return Subject::dice; }},
      pane.glass);
}

PaneMeasures measured(const glass::CrackNetwork& network, const glass::Pane& pane) {
  PaneMeasures result;
  for (const glass::ImpactCounts& impact : network.impacts) result.impacts.emplace_back().drawn = impact;
  const vec2 origin_mm = geometry::bounding_box(pane.outline_mm).low;
  for (std::size_t i = 0; i < network.cracks.size(); ++i) {
    add_crack(network, i, pane, origin_mm, result.impacts[static_cast<std::size_t>(network.cracks[i].impact)]);
  }
  for (std::size_t i = 0; i < result.impacts.size(); ++i) {
    ImpactMeasures& of_impact = result.impacts[i];
    of_impact.room_mm = nearest_side(of_impact.drawn.at_mm, pane.outline_mm).distance_mm;
    of_impact.gap_ratio = radial_spread(network, static_cast<int>(i), of_impact.room_mm);
    of_impact.reaching_gap_variation = variation_of_reaching_gaps(network, static_cast<int>(i), of_impact.room_mm);
    count_gaps(network, static_cast<int>(i), of_impact);
  }
  const auto impact_of = [&](int crack) { return network.cracks[static_cast<std::size_t>(crack)].impact; };
  for (const Crossing& crossing : crossings(network)) {
    const int later = std::max(impact_of(crossing.crack), impact_of(crossing.other));
    ++result.impacts[static_cast<std::size_t>(later)].crossing_count;
  }
  result.subject = subject_of(pane);
  if (result.subject == Subject::experiment && !result.impacts.empty() && result.impacts.front().crossing_count == 0) {
    result.impacts.front().enclosed_tips = enclosed_tips(network, 0);
  }
  if (result.subject == Subject::dice) {
    result.fragment_counts = fragment_counts(network, pane);
    result.least_fragment_count = glass::least_fragment_count(pane.thickness_mm);
  }
  const bool real = pane.pattern == glass::Pattern::real && std::holds_alternative<glass::Annealed>(pane.glass);
  if (real && !network.impacts.empty()) result.pattern = pattern_measures(network, pane);
  return result;
}

Angle edge_angle(const Crack& crack, const geometry::Polygon& outline_mm) {
  const std::vector<vec2> backwards(crack.points_mm.rbegin(), crack.points_mm.rend());
  // The first feature point of the line run backwards; only what lies within a chord of the tip and the segment out is looked
  // at.
  const auto out = std::ranges::find_if(backwards, [&](vec2 p) { return glm::length(p - backwards.front()) >= chord_mm; });
  const std::vector<vec2> points =
      tracked(std::span(backwards).first(static_cast<std::size_t>(std::min(out + 1, backwards.end()) - backwards.begin())));
  const vec2 chord = backwards.front() - (points.size() > 1 ? points[1] : backwards.back());
  const vec2 side = nearest_side(backwards.front(), outline_mm).along;
  return Angle::radians(arctangent(std::abs(cross(side, chord)), std::abs(glm::dot(side, chord))));
}

Angle ring_end_angle(const Crack& ring, const Crack& met) {
  const vec2 tip = ring.points_mm.back();
  const std::vector<vec2> points =
      tracked(std::vector<vec2>(ring.points_mm.rbegin(), ring.points_mm.rend()), ring_end_chord_mm);
  const vec2 chord = tip - (points.size() > 1 ? points[1] : ring.points_mm.front());
  const auto at = std::ranges::min_element(met.points_mm, {}, [&](vec2 p) { return glm::length(p - tip); });
  const vec2 along = *(at + 1 == met.points_mm.end() ? at : at + 1) - *(at == met.points_mm.begin() ? at : at - 1);
  return Angle::radians(arctangent(std::abs(cross(along, chord)), std::abs(glm::dot(along, chord))));
}

double gap_ratio(std::vector<Angle> directions) {
  std::ranges::sort(directions);
  const double count = static_cast<double>(directions.size());
  const double mean = 2.0 * pi / count;
  double squares = 0.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const bool last = i + 1 == directions.size();
    const double gap = (directions[last ? 0 : i + 1] - directions[i]).radians() + (last ? 2.0 * pi : 0.0);
    squares += (gap - mean) * (gap - mean);
  }
  return squares / count / (mean * mean) * (count + 1.0) / (count - 1.0);
}

std::vector<Angle> radial_directions(const glass::CrackNetwork& network, int impact, double radius_mm) {
  const vec2 centre = network.impacts[static_cast<std::size_t>(impact)].at_mm;
  std::vector<Angle> directions;
  for (const Crack& crack : network.cracks) {
    if (crack.impact != impact || !is_radial(crack.kind)) continue;
    if (const auto direction = direction_at(crack, centre, radius_mm)) directions.push_back(*direction);
  }
  return directions;
}

double narrow_gap_radius_mm(int radial_count) { return experiment_ring_radius_mm(radial_count) + beyond_ring_mm; }

double spread_radius_mm(int radial_count) { return greatest_ring_ratio * experiment_ring_radius_mm(radial_count); }

}  // namespace shatterpave::measure
