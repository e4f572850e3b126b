// The cracks are walked one after another, those first on which others end, and each straight piece keeps what is left of it
// when all that would come too near to earlier tubes, the outline and the crushed zones is taken away. "Too near" to an earlier
// tube is a stadium about its axis; a line passes it in one interval, so what is taken away is a list of intervals, and all is
// + - * / and sqrt. Within a crack, neighbouring tubes are cut back at their common vertex as far as their flat ends would
// meet.

#include "export/shapes/tubes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/functions.h"
#include "geometry/lattice.h"
#include "geometry/polygon.h"
#include "geometry/segment_index.h"
#include "glass/map/crack_paths.h"
#include "glass/sheets.h"

namespace shatterpave::exporting::shapes {

namespace {

using glass::Crack;
using glass::CrackEnd;
using glass::CrackKind;

// Radius of a tube by the thickness of the pane. By eye: a crack is a sheet through the thickness, never quite upright, and
// shows about a fifth of the thickness wide.
constexpr double radius_by_thickness = 0.09;
// Cracks that do not run through to the edge are less open. By eye.
constexpr double narrow_share = 0.75;
// A tip within the glass is narrower still, over the last third of its crack. By eye.
constexpr double tip_share = 0.3;
constexpr double tip_length_share = 0.33;
// The crushed zone is at least as wide as the glass is thick by this factor.
constexpr double zone_by_thickness = 1.5;
// Room between radials on the ring, as a multiple of what they take, since they are not spread quite evenly. By eye.
constexpr double ring_room = 1.25;
// Below 10 lattice steps a radius has no meaning; with so many radials the outer ones are cut back instead.
constexpr double smallest_radius_mm = 0.01;
// Pieces shorter than this many radii are left out: they would be a speck.
constexpr double shortest_piece = 1.0;

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

// A piece of a crack as a ray: origin + t direction, 0 <= t <= length.
struct Ray {
  vec2 origin;
  vec2 direction;  // unit
  double length = 0.0;
};

void widen(std::optional<Interval>& hull, double low, double high) {
  if (low > high) return;
  hull = hull ? Interval{std::min(hull->low, low), std::max(hull->high, high)} : Interval{low, high};
}

// Where the line of `ray` is within `reach` of `centre`.
void widen_by_disc(std::optional<Interval>& hull, const Ray& ray, vec2 centre, double reach) {
  const vec2 to_centre = centre - ray.origin;
  const double middle = glm::dot(to_centre, ray.direction);
  const double aside = cross(ray.direction, to_centre);
  const double half = reach * reach - aside * aside;
  if (half < 0.0) return;
  widen(hull, middle - std::sqrt(half), middle + std::sqrt(half));
}

// Where the line of `ray` passes the rectangle about the segment a → b whose sides are `reach` away.
void widen_by_strip(std::optional<Interval>& hull, const Ray& ray, vec2 a, vec2 b, double reach) {
  const double length = glm::length(b - a);
  if (length == 0.0) return;
  const vec2 along = (b - a) / length;
  Interval inside{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const auto clip = [&](double start, double slope, double low, double high) {
    if (slope == 0.0) {
      if (start < low || start > high) inside = {1.0, 0.0};
      return;
    }
    const double t0 = (low - start) / slope;
    const double t1 = (high - start) / slope;
    inside = {std::max(inside.low, std::min(t0, t1)), std::min(inside.high, std::max(t0, t1))};
  };
  clip(glm::dot(ray.origin - a, along), glm::dot(ray.direction, along), 0.0, length);
  clip(cross(along, ray.origin - a), cross(along, ray.direction), -reach, reach);
  widen(hull, inside.low, inside.high);
}

std::optional<Interval> stadium_interval(const Ray& ray, vec2 a, vec2 b, double reach) {
  std::optional<Interval> hull;
  widen_by_disc(hull, ray, a, reach);
  widen_by_disc(hull, ray, b, reach);
  widen_by_strip(hull, ray, a, b, reach);
  return hull;
}

// What is left of [low, high] without `taken`, in order.
std::vector<Interval> remainder(Interval whole, std::vector<Interval> taken) {
  std::ranges::sort(taken, {}, &Interval::low);
  std::vector<Interval> left;
  for (const Interval& hole : taken) {
    if (hole.high <= whole.low) continue;
    if (hole.low >= whole.high) break;
    if (hole.low > whole.low) left.push_back({whole.low, hole.low});
    whole.low = hole.high;
  }
  if (whole.low < whole.high) left.push_back(whole);
  return left;
}

// Something that tubes keep away from: an earlier tube, or a side of the outline (radius 0, chain -1).
struct Obstacle {
  vec2 a;
  vec2 b;
  double radius = 0.0;
  int chain = -1;
  std::size_t piece = 0;
};

class Obstacles {
 public:
  explicit Obstacles(double cell_mm) : index_(cell_mm) {}

  void add(const Obstacle& obstacle) {
    index_.add({geometry::to_lattice(obstacle.a), geometry::to_lattice(obstacle.b)});
    obstacles_.push_back(obstacle);
    largest_radius_ = std::max(largest_radius_, obstacle.radius);
  }

  // The obstacles within `reach` of the segment a → b beyond their own radius, and some more.
  std::vector<Obstacle> near(vec2 a, vec2 b, double reach) const {
    const vec2 margin{reach + largest_radius_, reach + largest_radius_};
    std::vector<Obstacle> result;
    for (const int number :
         index_.near(geometry::to_lattice(glm::min(a, b) - margin), geometry::to_lattice(glm::max(a, b) + margin))) {
      result.push_back(obstacles_[static_cast<std::size_t>(number)]);
    }
    return result;
  }

 private:
  geometry::SegmentIndex index_;  // its numbers are the indices of obstacles_
  double largest_radius_ = 0.0;
  std::vector<Obstacle> obstacles_;
};

// ---- crushed zones, and how thick the tubes of each impact may be

struct ImpactShape {
  glass::ImpactZone zone;
  double radius_mm = 0.0;  // of the tubes
};

std::vector<int> radial_counts(const glass::CrackNetwork& network) {
  std::vector<int> counts(network.impacts.size(), 0);
  for (const Crack& crack : network.cracks) {
    if (crack.start.at == CrackEnd::At::impact) ++counts[static_cast<std::size_t>(crack.impact)];
  }
  return counts;
}

// The ring on which `count` tubes have room side by side: neighbours at 360°/count are a chord apart. Where the ring would be
// too large, the tubes are made thinner.
ImpactShape impact_shape(vec2 centre, int count, double thickness_mm, double largest_ring_mm) {
  const double half_angle_sine = count < 2 ? 1.0 : sine(pi / count);
  ImpactShape shape{{centre, 0.0}, radius_by_thickness * thickness_mm};
  const auto ring = [&](double radius) { return ring_room * (radius + 0.5 * tube_clearance_mm) / half_angle_sine; };
  shape.zone.radius_mm = std::min(largest_ring_mm, std::max(zone_by_thickness * thickness_mm, ring(shape.radius_mm)));
  if (ring(shape.radius_mm) > shape.zone.radius_mm) {
    shape.radius_mm = std::clamp(shape.zone.radius_mm * half_angle_sine / ring_room - 0.5 * tube_clearance_mm,
                                 std::min(smallest_radius_mm, shape.radius_mm), shape.radius_mm);
  }
  return shape;
}

std::vector<ImpactShape> impact_shapes(const glass::Pane& pane, const glass::CrackNetwork& network) {
  const std::vector<int> counts = radial_counts(network);
  const std::vector<double> limits = glass::zone_limits_mm(pane, network);
  const double thickness = glass::sheet_of(pane, glass::Ply::near).thickness_mm;
  std::vector<ImpactShape> shapes;
  for (std::size_t i = 0; i < network.impacts.size(); ++i) {
    shapes.push_back(impact_shape(network.impacts[i].at_mm, counts[i], thickness, limits[i]));
  }
  return shapes;
}

// ---- chains

struct Chain {
  std::vector<vec2> points;
  int crack = 0;
  double radius = 0.0;
  bool narrow_start = false;  // ends within the glass
  bool narrow_end = false;
};

bool is_in_glass(CrackEnd::At end) { return end == CrackEnd::At::open || end == CrackEnd::At::enclosed; }

// A crack that is still on its way to the edge, or to another one, is as wide as it will be.
bool ends_within(const Crack& crack) { return is_in_glass(end_in_time(crack)); }

double chain_radius(const Crack& crack, const std::vector<ImpactShape>& shapes) {
  const double share = crack.kind == CrackKind::large ? 1.0 : narrow_share;
  return share * shapes[static_cast<std::size_t>(crack.impact)].radius_mm;
}

std::vector<Chain> chains(const glass::CrackNetwork& network, const std::vector<ImpactShape>& shapes) {
  std::vector<Chain> result;
  for (glass::CrackPath& path : glass::crack_paths(network)) {
    const Crack& crack = network.crack(path.crack);
    const bool narrow_start = path.other_arm ? ends_within(network.crack(*path.other_arm)) : is_in_glass(path.start.at);
    result.push_back({std::move(path.points_mm), path.crack, chain_radius(crack, shapes), narrow_start, ends_within(crack)});
  }
  return result;
}

// Without the vertices that follow the last kept one more closely than 4 radii: pieces shorter than a tube is thick would be
// cut away at their turns. The last point stays.
std::vector<vec2> thinned(const std::vector<vec2>& points, double radius) {
  std::vector<vec2> kept{points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (glm::length(points[i] - kept.back()) >= 4.0 * radius) kept.push_back(points[i]);
  }
  if (kept.size() > 1 && glm::length(points.back() - kept.back()) < 4.0 * radius) kept.pop_back();
  kept.push_back(points.back());
  return kept;
}

// ---- tubes

// At a vertex: how far flat ends of tubes with radius 1 must stay back so that they do not meet, or nothing for turns above
// 90°, where neighbours keep away from each other as from any other tube. tan(a/2) = sin a / (1 + cos a).
std::optional<double> setback(vec2 before, vec2 after) {
  const double cosine_of_turn = glm::dot(before, after);
  if (cosine_of_turn < 0.0) return std::nullopt;
  return std::abs(cross(before, after)) / (1.0 + cosine_of_turn);
}

class Trimming {
 public:
  // Tubes lie within one of the bodies each.
  Trimming(const glass::Pane& pane, const std::vector<geometry::Region>& bodies, const std::vector<ImpactShape>& shapes)
      : bodies_(bodies), obstacles_(std::max(1.0, pane.thickness_mm)), shapes_(shapes) {
    const auto add = [&](const geometry::Polygon& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) obstacles_.add({ring[i], ring[(i + 1) % ring.size()]});
    };
    for (const geometry::Region& body : bodies) {
      add(body.outline);
      std::ranges::for_each(body.holes, add);
    }
  }

  // The tubes of `chain`, which is the number-th; later chains keep away from them.
  void append_tubes(const Chain& chain, int number, std::vector<Tube>& tubes) {
    const std::vector<vec2> points = thinned(chain.points, chain.radius);
    const std::vector<double> radii = piece_radii(points, chain);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double length = glm::length(points[i + 1] - points[i]);
      if (length == 0.0) continue;
      const Ray ray{points[i], (points[i + 1] - points[i]) / length, length};
      Interval whole{0.0, length};
      bool follows = false;
      if (const std::optional<double> back = setback_at(points, i)) {
        follows = true;
        whole.low = *back * std::max(radii[i], radii[i - 1]) + 0.5 * tube_clearance_mm;
      }
      if (const std::optional<double> back = setback_at(points, i + 1)) {
        whole.high = length - *back * std::max(radii[i], radii[i + 1]) - 0.5 * tube_clearance_mm;
      }
      for (const Interval& piece : remainder(whole, taken(ray, radii[i], number, i, follows))) {
        if (piece.high - piece.low < shortest_piece * radii[i]) continue;
        if (!is_within(ray.origin + 0.5 * (piece.low + piece.high) * ray.direction)) continue;
        const Tube tube{geometry::on_lattice(ray.origin + piece.low * ray.direction),
                        geometry::on_lattice(ray.origin + piece.high * ray.direction), radii[i], chain.crack};
        tubes.push_back(tube);
        obstacles_.add({tube.a_mm, tube.b_mm, tube.radius_mm, number, i});
      }
    }
  }

 private:
  static std::optional<double> setback_at(const std::vector<vec2>& points, std::size_t i) {
    if (i == 0 || i + 1 >= points.size()) return std::nullopt;
    const vec2 before = points[i] - points[i - 1];
    const vec2 after = points[i + 1] - points[i];
    const double lengths = glm::length(before) * glm::length(after);
    if (lengths == 0.0) return std::nullopt;
    return setback(before / glm::length(before), after / glm::length(after));
  }

  static std::vector<double> piece_radii(const std::vector<vec2>& points, const Chain& chain) {
    std::vector<double> middles;
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double piece = glm::length(points[i + 1] - points[i]);
      middles.push_back(length + 0.5 * piece);
      length += piece;
    }
    const auto share = [&](bool narrow, double from_tip) {
      return narrow ? std::clamp(from_tip / (tip_length_share * length), tip_share, 1.0) : 1.0;
    };
    std::vector<double> radii;
    for (const double middle : middles) {
      // To four digits: more would only be noise in a file.
      const double radius =
          chain.radius * std::min(share(chain.narrow_start, middle), share(chain.narrow_end, length - middle));
      radii.push_back(std::max(1.0, std::round(radius * 1e4)) / 1e4);
    }
    return radii;
  }

  // Where a tube along `ray` would come too near to something.
  std::vector<Interval> taken(const Ray& ray, double radius, int chain, std::size_t piece, bool follows) const {
    std::vector<Interval> result;
    const auto take = [&](const std::optional<Interval>& interval) {
      if (interval) result.push_back(*interval);
    };
    const double reach = radius + tube_clearance_mm;
    for (const Obstacle& obstacle : obstacles_.near(ray.origin, ray.origin + ray.length * ray.direction, reach)) {
      if (follows && obstacle.chain == chain && obstacle.piece + 1 == piece) continue;
      if (obstacle.chain == chain && obstacle.piece == piece) continue;
      take(stadium_interval(ray, obstacle.a, obstacle.b, reach + obstacle.radius));
    }
    for (const ImpactShape& shape : shapes_) {
      take(stadium_interval(ray, shape.zone.centre_mm, shape.zone.centre_mm, reach + shape.zone.radius_mm));
    }
    return result;
  }

  // Borders are obstacles, so that a piece between two of them has one of its points within a body if it has all.
  bool is_within(vec2 point) const {
    return std::ranges::any_of(bodies_, [&](const geometry::Region& body) { return geometry::contains(body, point); });
  }

  const std::vector<geometry::Region>& bodies_;
  Obstacles obstacles_;
  const std::vector<ImpactShape>& shapes_;
};

std::vector<Tube> trimmed_tubes(const glass::Pane& pane, const glass::CrackNetwork& network,
                                const std::vector<geometry::Region>& bodies, const std::vector<ImpactShape>& shapes) {
  std::vector<Tube> tubes;
  Trimming trimming(pane, bodies, shapes);
  int number = 0;
  for (const Chain& chain : chains(network, shapes)) trimming.append_tubes(chain, number++, tubes);
  return tubes;
}

}  // namespace

TubedCracks tubed_cracks(const glass::Pane& pane, const glass::CrackNetwork& network, const glass::CrackNetwork& far) {
  const std::vector<ImpactShape> shapes = impact_shapes(pane, network);
  TubedCracks result;
  for (const ImpactShape& shape : shapes) result.zones.push_back(shape.zone);
  const std::vector<geometry::Region> slab{{pane.outline_mm, {}}};
  const auto add = [&](const glass::CrackNetwork& of_sheet, glass::Ply ply) {
    for (Tube& tube : trimmed_tubes(pane, of_sheet, slab, shapes)) {
      tube.z_mm = glass::sheet_of(pane, ply).middle_mm;
      result.tubes.push_back(tube);
    }
  };
  add(network, glass::Ply::near);
  if (!far.cracks.empty()) add(far, glass::Ply::far);
  return result;
}

std::vector<Tube> tubes_within(const glass::Pane& pane, const glass::CrackNetwork& network,
                               const std::vector<geometry::Region>& bodies) {
  return trimmed_tubes(pane, network, bodies, impact_shapes(pane, network));
}

std::vector<Tube> joined_tubes(const BrokenPane& broken) {
  std::vector<geometry::Region> bodies;
  for (const glass::Shard& shard : broken.shards) {
    if (shard.state != glass::ShardState::missing && !shard.joined.empty()) bodies.push_back(shard.face);
  }
  return bodies.empty() ? std::vector<Tube>{} : tubes_within(broken.pane, broken.network, bodies);
}

std::vector<glass::ImpactZone> crushed_zones(const glass::CrackSurfaces& surfaces) {
  std::vector<glass::ImpactZone> zones;
  for (const glass::ImpactZone& zone : surfaces.zones) {
    const auto is_here = [&](const glass::ShotHole& shot_hole) { return shot_hole.shape.centre_mm == zone.centre_mm; };
    if (std::ranges::none_of(surfaces.shot_holes, is_here)) zones.push_back(zone);
  }
  return zones;
}

}  // namespace shatterpave::exporting::shapes
