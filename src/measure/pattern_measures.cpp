#include "measure/pattern_measures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/functions.h"
#include "geometry/hull.h"
#include "geometry/segment_distance.h"
#include "glass/growth/radial_course.h"
#include "glass/shards/shard_faces.h"
#include "measure/distribution.h"
#include "measure/pane_measures.h"

namespace shatterpave::measure {

namespace {

using glass::Crack;
using glass::CrackKind;

// Two pieces of a ring that end on a radial nearer to each other than this end in one place: what rounding and the width of a
// crack leave.
constexpr double one_place_mm = 0.1;

// Rings of fewer pieces say little of their radius.
constexpr std::size_t least_ring_pieces = 6;

double radius_of_crushed_zone(const glass::CrackNetwork& network) {
  const auto& crater = network.impacts.front().crater;
  return crater ? crater->crushed_radius_mm : 0.0;
}

bool is_radial(const Crack& crack) {
  return crack.impact == 0 && (crack.kind == CrackKind::large || crack.kind == CrackKind::radial);
}

// The ring to which something at that distance belongs: the nearest.
std::size_t ring_at(const std::vector<double>& radii, double distance) {
  const auto off = [&](double radius) { return std::abs(logarithm(distance / radius)); };
  return static_cast<std::size_t>(std::ranges::min_element(radii, {}, off) - radii.begin());
}

// A piece of a ring: its two arms, one after the other in the network.
struct RingPiece {
  std::size_t ring = 0;
  std::array<const Crack*, 2> arms{};
};

std::vector<RingPiece> ring_pieces(const glass::CrackNetwork& network, const std::vector<double>& radii) {
  const vec2 impact = network.impacts.front().at_mm;
  std::map<std::pair<double, double>, RingPiece> by_start;
  for (const Crack& crack : network.cracks) {
    if (crack.kind != CrackKind::circular || crack.impact != 0) continue;
    RingPiece& piece = by_start[{crack.points_mm.front().x, crack.points_mm.front().y}];
    piece.arms[piece.arms[0] == nullptr ? 0 : 1] = &crack;
  }
  std::vector<RingPiece> pieces;
  for (auto& [start, piece] : by_start) {
    if (piece.arms[1] == nullptr) continue;
    const vec2 middle =
        (piece.arms[0]->points_mm.back() + piece.arms[1]->points_mm.back() + piece.arms[0]->points_mm.front()) / 3.0;
    piece.ring = ring_at(radii, glm::length(middle - impact));
    pieces.push_back(piece);
  }
  return pieces;
}

// Where a ring meets a radial, from one side and from the other.
struct Joint {
  std::array<std::optional<vec2>, 2> ends;
};

// Whether the end of `arm` lies on the left of `radial`, seen from the impact.
bool comes_from_left(const Crack& arm, vec2 impact) {
  const vec2 end = arm.points_mm.back();
  return cross(end - impact, arm.points_mm[arm.points_mm.size() - 2] - end) > 0.0;
}

double turn_at(const std::vector<vec2>& line, std::size_t i) {
  const vec2 before = line[i] - line[i - 1];
  const vec2 after = line[i + 1] - line[i];
  return std::abs(arctangent(cross(before, after), glm::dot(before, after)));
}

// How far the radial turns where a piece of a ring ends on it, unless that is at one of its own ends.
void add_kink(const Crack& radial, vec2 end, PatternMeasures& result) {
  const auto at = std::ranges::find(radial.points_mm, end);
  if (at == radial.points_mm.begin() || at >= radial.points_mm.end() - 1) return;
  const auto turn = turn_at(radial.points_mm, static_cast<std::size_t>(at - radial.points_mm.begin()));
  result.kinks_deg.push_back(Angle::radians(turn).degrees());
}

void add_joints(const std::vector<RingPiece>& pieces, const glass::CrackNetwork& network, PatternMeasures& result) {
  const vec2 impact = network.impacts.front().at_mm;
  std::map<std::pair<std::size_t, int>, Joint> joints;
  for (const RingPiece& piece : pieces) {
    for (const Crack* arm : piece.arms) {
      if (arm->end.at != glass::CrackEnd::At::crack) continue;
      const Crack& met = network.cracks[static_cast<std::size_t>(*arm->end.crack)];
      if (!is_radial(met)) continue;
      joints[{piece.ring, met.id}].ends[comes_from_left(*arm, impact) ? 0 : 1] = arm->points_mm.back();
      add_kink(met, arm->points_mm.back(), result);
    }
  }
  for (const auto& [place, joint] : joints) {
    if (!joint.ends[0] || !joint.ends[1]) continue;
    ++result.joint_count;
    if (glm::length(*joint.ends[0] - *joint.ends[1]) > one_place_mm) ++result.staggered_count;
  }
}

void add_rings(const std::vector<RingPiece>& pieces, const std::vector<double>& radii, const glass::CrackNetwork& network,
               PatternMeasures& result) {
  const vec2 impact = network.impacts.front().at_mm;
  for (std::size_t k = 0; k < radii.size(); ++k) {
    Distribution distances;
    std::size_t count = 0;
    for (const RingPiece& piece : pieces) {
      if (piece.ring != k) continue;
      ++count;
      for (const Crack* arm : piece.arms) distances.add(glm::length(arm->points_mm.back() - impact));
    }
    const int sectors = static_cast<int>(radial_directions(network, 0, radii[k]).size());
    result.sector_count += sectors;
    result.gap_count += std::max(sectors - static_cast<int>(count), 0);
    if (count >= least_ring_pieces) result.ring_variations.push_back(distances.deviation() / distances.mean());
  }
}

// Of a polygon, about its middle: ∫ x², ∫ y², ∫ xy.
double elongation_of(const geometry::Polygon& polygon, vec2 middle) {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const vec2 a = polygon[i] - middle;
    const vec2 b = polygon[(i + 1) % polygon.size()] - middle;
    const double area = cross(a, b);
    xx += area * (a.x * a.x + a.x * b.x + b.x * b.x) / 12.0;
    yy += area * (a.y * a.y + a.y * b.y + b.y * b.y) / 12.0;
    xy += area * (a.x * b.y + 2.0 * a.x * a.y + 2.0 * b.x * b.y + b.x * a.y) / 24.0;
  }
  const double mean = 0.5 * (xx + yy);
  const double off = std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
  return std::sqrt((mean + off) / std::max(mean - off, 1e-12));
}

void add_pieces(const glass::CrackNetwork& network, const glass::Pane& pane, PatternMeasures& result) {
  const vec2 impact = network.impacts.front().at_mm;
  const glass::FacedPane faced = glass::faced_pane(pane, network);
  for (const glass::ShardFace& face : faced.faces) {
    const geometry::Region region = glass::region(face.face);
    const double area = geometry::area(region);
    if (area < least_piece_mm2) continue;
    const vec2 middle = geometry::centroid(region.outline);
    const bool at_edge = std::ranges::any_of(face.face.outline, [&](const geometry::FaceSide& side) {
      return faced.segments[side.segment].owner == glass::pane_edge;
    });
    const double hull = geometry::area(geometry::convex_hull(region.outline));
    result.pieces.push_back({area, glm::length(middle - impact), elongation_of(region.outline, middle), area / hull, at_edge});
  }
}

}  // namespace

double gap_variation(std::vector<Angle> directions) {
  std::ranges::sort(directions);
  Distribution gaps;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const bool last = i + 1 == directions.size();
    gaps.add((directions[last ? 0 : i + 1] - directions[i]).radians() + (last ? 2.0 * pi : 0.0));
  }
  return gaps.deviation() / gaps.mean();
}

PatternMeasures pattern_measures(const glass::CrackNetwork& network, const glass::Pane& pane) {
  PatternMeasures result;
  const double crushed_mm = radius_of_crushed_zone(network);
  if (crushed_mm > 0.0) {
    for (std::size_t i = 0; i < counting_radii.size(); ++i) {
      const std::vector<Angle> directions = radial_directions(network, 0, counting_radii[i] * crushed_mm);
      result.radial_counts[i] = static_cast<int>(directions.size());
      if (i == 1 && directions.size() > 2) result.gap_variation = gap_variation(directions);
    }
  }
  result.chip_count = static_cast<int>(std::ranges::count(network.cracks, CrackKind::chip, &Crack::kind));
  double farthest = 0.0;
  for (const vec2& vertex : pane.outline_mm) farthest = std::max(farthest, glm::length(vertex - network.impacts.front().at_mm));
  const std::vector<double> radii = glass::ring_radii(pane, farthest);
  result.room_mm = farthest;
  for (std::size_t i = 0; i < pane.outline_mm.size(); ++i) {
    result.room_mm = std::min(result.room_mm, geometry::distance_to_segment(network.impacts.front().at_mm, pane.outline_mm[i],
                                                                            pane.outline_mm[(i + 1) % pane.outline_mm.size()]));
  }
  if (!radii.empty()) {
    result.first_ring_mm = radii.front();
    const std::vector<RingPiece> pieces = ring_pieces(network, radii);
    add_joints(pieces, network, result);
    add_rings(pieces, radii, network, result);
  }
  add_pieces(network, pane, result);
  return result;
}

}  // namespace shatterpave::measure
