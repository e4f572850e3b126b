// Half the distance to what is nearest would do if room were known everywhere. It is known at stations: from the distances D0,
// D1 at two of them, a step apart, that in between is at least their linear interpolation less half the step. So a quarter of a
// step is taken off, and steps are short where there is little room.

#include "glass/gaps/crack_corridor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/lattice.h"
#include "geometry/segment_distance.h"

namespace shatterpave::glass {

namespace {

// Vertices nearer than this to the one before are left out, and no step is shorter but the last one of a piece.
constexpr double shortest_step_mm = 0.08;
// A step in units of the distance to what is nearest: a quarter of it, which is lost, is a quarter of what there would be.
constexpr double step_by_distance = 0.5;
// Neighbouring lines across a crack that turns would meet at 1.
constexpr double share_of_turn = 0.45;
// Two places of a path that are nearer to each other than this share of the way between them.
constexpr double turned_back = 0.6;
// By how much room may grow along a step, so that walls do not jump aside.
constexpr double growth_of_room = 0.4;

// A crack that ends at the edge ends within 1 µm of it.
constexpr double edge_reach_mm = 0.002;

constexpr double infinity = std::numeric_limits<double>::infinity();

using Interval = Corridors::Interval;

void cut_out(std::vector<Interval>& parts, Interval hole) {
  std::vector<Interval> left;
  for (const Interval& part : parts) {
    if (hole.high < part.low || hole.low > part.high) {
      left.push_back(part);
      continue;
    }
    if (part.low < hole.low) left.push_back({part.low, hole.low});
    if (hole.high < part.high) left.push_back({hole.high, part.high});
  }
  parts = std::move(left);
}

std::vector<vec2> thinned(const std::vector<vec2>& points) {
  std::vector<vec2> kept{points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (glm::length(points[i] - kept.back()) >= shortest_step_mm) kept.push_back(points[i]);
  }
  kept.push_back(points.back());
  return kept;
}

double length_of(const std::vector<vec2>& points) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) length += glm::length(points[i + 1] - points[i]);
  return length;
}

// Without what lies in the zone before the path leaves it for the first time; empty where it does not.
std::vector<vec2> outside(const std::vector<vec2>& points, const ImpactZone& zone) {
  const auto is_out = [&](vec2 p) { return glm::length(p - zone.centre_mm) >= zone.start_mm; };
  const auto first = std::ranges::find_if(points, is_out);
  if (first == points.end()) return {};
  if (first == points.begin()) return points;
  const vec2 from = *(first - 1) - zone.centre_mm;
  const vec2 side = *first - *(first - 1);
  const double a = glm::dot(side, side);
  const double b = glm::dot(from, side);
  const double c = glm::dot(from, from) - zone.start_mm * zone.start_mm;
  const double u = std::clamp((-b + std::sqrt(std::max(0.0, b * b - a * c))) / a, 0.0, 1.0);
  std::vector<vec2> rest{*(first - 1) + u * side};
  rest.insert(rest.end(), glm::length(*first - rest.front()) > 0.0 ? first : first + 1, points.end());
  return rest;
}

vec2 point_along(const std::vector<vec2>& points, double along) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double length = glm::length(points[i + 1] - points[i]);
    if (along <= length && length > 0.0) return points[i] + along / length * (points[i + 1] - points[i]);
    along -= length;
  }
  return points.back();
}

double along_nearest(const std::vector<vec2>& points, vec2 point) {
  double best = infinity;
  double result = 0.0;
  double along = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const vec2 side = points[i + 1] - points[i];
    const double length = glm::length(side);
    const double u = length == 0.0 ? 0.0 : std::clamp(glm::dot(point - points[i], side) / (length * length), 0.0, 1.0);
    const double distance = glm::length(point - (points[i] + u * side));
    if (distance < best) {
      best = distance;
      result = along + u * length;
    }
    along += length;
  }
  return result;
}

}  // namespace

Corridors::Corridors(const Pane& pane, const CrackNetwork& network, const std::vector<ImpactZone>& zones,
                     const CorridorShape& shape)
    : shape_(shape), zones_(zones), paths_(crack_paths(network)), index_(std::max(1.0, shape.reach_mm)) {
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    CrackPath& path = paths_[i];
    const bool from_impact = path.start.at == CrackEnd::At::impact;
    own_zones_.push_back(from_impact ? network.crack(path.crack).impact : -1);
    path.points_mm = thinned(path.points_mm);
    if (from_impact) path.points_mm = outside(path.points_mm, zones_[static_cast<std::size_t>(own_zones_[i])]);
    // The border of a flake hugs the crack that it leaves and comes back to: it has no room there, and would take it from that
    // one.
    if (network.crack(path.crack).kind == CrackKind::chip) path.points_mm.clear();
    lengths_.push_back(length_of(path.points_mm));
    double along = 0.0;
    for (std::size_t k = 0; k + 1 < path.points_mm.size(); ++k) {
      add_piece({i, along, path.points_mm[k], path.points_mm[k + 1]});
      along += glm::length(path.points_mm[k + 1] - path.points_mm[k]);
    }
  }
  for (std::size_t k = 0; k < pane.outline_mm.size(); ++k) {
    add_piece({outline, 0.0, pane.outline_mm[k], pane.outline_mm[(k + 1) % pane.outline_mm.size()]});
  }
  add_joints(network);
}

double Corridors::along_mm(std::size_t path, vec2 point) const { return along_nearest(paths_[path].points_mm, point); }

void Corridors::add_piece(const Piece& piece) {
  index_.add({geometry::to_lattice(piece.a), geometry::to_lattice(piece.b)});
  pieces_.push_back(piece);
}

void Corridors::add_joint(std::size_t path, bool at_end, std::size_t on) {
  const std::vector<vec2>& points = paths_[path].points_mm;
  const std::vector<vec2>& others = paths_[on].points_mm;
  if (on == path || points.size() < 2 || others.size() < 2) return;
  const double along = along_nearest(others, at_end ? points.back() : points.front());
  std::vector<std::pair<vec2, vec2>> to;
  for (std::size_t k = 0; k + 1 < others.size(); ++k) to.emplace_back(others[k], others[k + 1]);
  joints_of_[path].push_back(joints_.size());
  joints_of_[on].push_back(joints_.size());
  joints_.push_back({path, at_end, on, along, approach_sine(path, at_end, to)});
}

// As the sine of a joint, at the edge; 1 where the path does not end there.
double Corridors::edge_sine(std::size_t path, bool at_end) const {
  const std::vector<vec2>& points = paths_[path].points_mm;
  if ((at_end ? paths_[path].end : paths_[path].start).at != CrackEnd::At::edge || points.size() < 2) return 1.0;
  const vec2 tip = at_end ? points.back() : points.front();
  const vec2 reach{2.0 * shape_.joint_mm, 2.0 * shape_.joint_mm};
  return approach_sine(path, at_end, sides_near(tip - reach, tip + reach));
}

void Corridors::add_joints(const CrackNetwork& network) {
  std::vector<std::size_t> path_of(network.cracks.size(), 0);
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    path_of[network.index_of(paths_[i].crack)] = i;
    path_of[network.index_of(paths_[i].other_arm.value_or(paths_[i].crack))] = i;
  }
  joints_of_.resize(paths_.size());
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    edge_sines_.emplace_back(edge_sine(i, false), edge_sine(i, true));
    if (paths_[i].start.crack) add_joint(i, false, path_of[network.index_of(*paths_[i].start.crack)]);
    if (paths_[i].end.crack) add_joint(i, true, path_of[network.index_of(*paths_[i].end.crack)]);
  }
  leave_hooks();
}

// Two cracks that pass each other's tips may each end on the other, and run side by side in between. They have to keep apart
// there: so such joints are none, and the walls of both end where there is no room.
void Corridors::leave_hooks() {
  const double near = 4.0 * (shape_.joint_mm + shape_.longest_step_mm);
  const auto tip_near = [&](const CrackJoint& joint, double along) {
    return std::abs((joint.at_end ? lengths_[joint.path] : 0.0) - along) <= near;
  };
  const auto hooked = [&](std::size_t number) {
    const CrackJoint& joint = joints_[number];
    return std::ranges::any_of(joints_of_[joint.on], [&](std::size_t other) {
      const CrackJoint& back = joints_[other];
      return back.path == joint.on && back.on == joint.path && tip_near(joint, back.along_mm) && tip_near(back, joint.along_mm);
    });
  };
  std::vector<bool> is_none(joints_.size(), false);
  for (std::size_t number = 0; number < joints_.size(); ++number) is_none[number] = hooked(number);
  for (std::vector<std::size_t>& joints : joints_of_)
    std::erase_if(joints, [&](std::size_t number) { return is_none[number]; });
}

// How far off the path is from the pieces, by how far it has to go to its end: the least within the reach of a joint.
double Corridors::approach_sine(std::size_t path, bool at_end, const std::vector<std::pair<vec2, vec2>>& to) const {
  double sine = 1.0;
  for (const double part : {0.125, 0.25, 0.5, 0.75, 1.0}) {
    const double back = std::min(part * shape_.joint_mm, lengths_[path]);
    const vec2 point = point_along(paths_[path].points_mm, at_end ? lengths_[path] - back : back);
    for (const auto& [a, b] : to) sine = std::min(sine, geometry::distance_to_segment(point, a, b) / back);
  }
  return sine;
}

// The most room that the joints near a place leave.
double Corridors::joint_room(std::size_t path, double along) const {
  double sine = 1.0;
  const double near = shape_.joint_mm + shape_.longest_step_mm;
  if (along <= near) sine = std::min(sine, edge_sines_[path].first);
  if (lengths_[path] - along <= near) sine = std::min(sine, edge_sines_[path].second);
  for (const std::size_t number : joints_of_[path]) {
    const CrackJoint& joint = joints_[number];
    const bool here = joint.path == path ? (joint.at_end ? lengths_[path] - along : along) <= near
                                         : std::abs(along - joint.along_mm) <= near + shape_.joint_mm;
    if (here) sine = std::min(sine, joint.sine);
  }
  return shape_.reach_mm * sine;
}

const CrackJoint* Corridors::joint(std::size_t path, bool at_end) const {
  for (const std::size_t number : joints_of_[path]) {
    if (joints_[number].path == path && joints_[number].at_end == at_end) return &joints_[number];
  }
  return nullptr;
}

bool Corridors::joins_near_end(std::size_t path, double reach_mm) const {
  return std::ranges::any_of(joints_of_[path], [&](std::size_t number) {
    const CrackJoint& joint = joints_[number];
    return joint.path == path && (joint.along_mm <= reach_mm || lengths_[joint.on] - joint.along_mm <= reach_mm);
  });
}

bool Corridors::joins(std::size_t path, std::size_t on) const {
  return std::ranges::any_of(joints_of_[path],
                             [&](std::size_t number) { return joints_[number].path == path && joints_[number].on == on; });
}

std::vector<std::pair<vec2, vec2>> Corridors::sides_near(vec2 low, vec2 high) const {
  std::vector<std::pair<vec2, vec2>> sides;
  for (const int number : index_.near(geometry::to_lattice(low), geometry::to_lattice(high))) {
    const Piece& piece = pieces_[static_cast<std::size_t>(number)];
    if (piece.path == outline) sides.emplace_back(piece.a, piece.b);
  }
  return sides;
}

// The part of another path, near a joint of the two, from which the place `along` the path is not kept apart.
void Corridors::cut_out_exempt(std::size_t path, double along, std::size_t other, std::vector<Interval>& parts) const {
  for (const std::size_t number : joints_of_[path]) {
    const CrackJoint& joint = joints_[number];
    if (joint.path == path && joint.on == other && (joint.at_end ? lengths_[path] - along : along) <= shape_.joint_mm) {
      cut_out(parts, {joint.along_mm - 2.0 * shape_.joint_mm, joint.along_mm + 2.0 * shape_.joint_mm});
    } else if (joint.on == path && joint.path == other && std::abs(along - joint.along_mm) <= 2.0 * shape_.joint_mm) {
      const double end = lengths_[other];
      cut_out(parts, joint.at_end ? Interval{end - shape_.joint_mm, end} : Interval{0.0, shape_.joint_mm});
    }
  }
}

// A path that ends at the edge is not kept apart from the side on which it does so.
double Corridors::distance_to_side(std::size_t path, double along, vec2 point, const Piece& side) const {
  const auto ends_on = [&](const CrackEnd& end, vec2 tip) {
    return end.at == CrackEnd::At::edge && geometry::distance_to_segment(tip, side.a, side.b) <= edge_reach_mm;
  };
  const CrackPath& of = paths_[path];
  const bool at_edge = (lengths_[path] - along <= shape_.joint_mm && ends_on(of.end, of.points_mm.back())) ||
                       (along <= shape_.joint_mm && ends_on(of.start, of.points_mm.front()));
  return at_edge ? infinity : geometry::distance_to_segment(point, side.a, side.b);
}

// From `point`, `along` the path, to what is not exempt of the piece.
double Corridors::distance_to_piece(std::size_t path, double along, vec2 point, const Piece& piece) const {
  if (piece.path == outline) return distance_to_side(path, along, point, piece);
  const double length = glm::length(piece.b - piece.a);
  std::vector<Interval> parts{{piece.from_mm, piece.from_mm + length}};
  if (piece.path == path) {
    // Near itself a path counts where it has turned back.
    const double apart = 4.0 * (shape_.reach_mm + shape_.longest_step_mm);
    const double way = std::abs(piece.from_mm + along_nearest({piece.a, piece.b}, point) - along);
    const double distance = geometry::distance_to_segment(point, piece.a, piece.b);
    if (way > shortest_step_mm && way < apart && distance < turned_back * way) return distance;
    cut_out(parts, {along - apart, along + apart});
  }
  cut_out_exempt(path, along, piece.path, parts);
  double nearest = infinity;
  const vec2 direction = length == 0.0 ? vec2{0.0, 0.0} : (piece.b - piece.a) / length;
  const auto at = [&](double place) { return piece.a + (place - piece.from_mm) * direction; };
  for (const Interval& part : parts)
    nearest = std::min(nearest, geometry::distance_to_segment(point, at(part.low), at(part.high)));
  return nearest;
}

// To all that the path must keep away from; no more than is asked for.
double Corridors::free_distance(std::size_t path, double along, vec2 point) const {
  double nearest = 2.0 * (shape_.reach_mm + crack_clearance_mm) + shape_.longest_step_mm;
  const vec2 reach{nearest, nearest};
  for (const int number : index_.near(geometry::to_lattice(point - reach), geometry::to_lattice(point + reach))) {
    nearest = std::min(nearest, distance_to_piece(path, along, point, pieces_[static_cast<std::size_t>(number)]));
  }
  for (std::size_t i = 0; i < zones_.size(); ++i) {
    if (static_cast<int>(i) == own_zones_[path]) continue;
    nearest = std::min(nearest, 2.0 * (glm::length(point - zones_[i].centre_mm) - zones_[i].radius_mm));
  }
  return nearest;
}

std::vector<Station> Corridors::stations(std::size_t path) const {
  const std::vector<vec2>& points = paths_[path].points_mm;
  std::vector<Station> result;
  if (points.size() < 2) return result;
  std::vector<vec2> normals;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) normals.push_back(left_of(glm::normalize(points[i + 1] - points[i])));
  double start = 0.0;
  const auto add = [&](vec2 point, vec2 across, double along) {
    result.push_back({point, across, along, free_distance(path, along, point)});
  };
  add(points.front(), normals.front(), 0.0);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const vec2 direction = -left_of(normals[i]);
    const double length = glm::length(points[i + 1] - points[i]);
    double done = 0.0;
    while (done < length) {
      const double step = std::clamp(step_by_distance * result.back().room_mm, shortest_step_mm, shape_.longest_step_mm);
      const bool last = length - done < 1.5 * step;
      done = last ? length : done + step;
      const bool turns = last && i + 1 < normals.size();
      const vec2 sum = turns ? normals[i] + normals[i + 1] : normals[i];
      const vec2 across = glm::length(sum) > 0.1 ? glm::normalize(sum) : normals[i];
      add(last ? points[i + 1] : points[i] + done * direction, across, start + done);
    }
    start += length;
  }
  limit_rooms(path, result);
  return result;
}

// From distances to rooms.
void Corridors::limit_rooms(std::size_t path, std::vector<Station>& stations) const {
  const auto step = [&](std::size_t i) { return stations[i + 1].along_mm - stations[i].along_mm; };
  std::vector<double> rooms;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    double room = joint_room(path, stations[i].along_mm);
    double longest = 0.0;
    for (std::size_t k = i == 0 ? 0 : i - 1; k < std::min(i + 1, stations.size() - 1); ++k) {
      longest = std::max(longest, step(k));
      const double turn = std::abs(cross(stations[k].across, stations[k + 1].across));
      if (turn > 0.0) room = std::min(room, share_of_turn * step(k) / turn);
    }
    rooms.push_back(std::min(room, 0.5 * stations[i].room_mm - 0.25 * longest - crack_clearance_mm));
  }
  for (std::size_t i = 1; i < rooms.size(); ++i) rooms[i] = std::min(rooms[i], rooms[i - 1] + growth_of_room * step(i - 1));
  for (std::size_t i = rooms.size() - 1; i-- > 0;) rooms[i] = std::min(rooms[i], rooms[i + 1] + growth_of_room * step(i));
  for (std::size_t i = 0; i < rooms.size(); ++i) stations[i].room_mm = rooms[i];
}

}  // namespace shatterpave::glass
