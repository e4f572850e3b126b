// Arcs are cubic Bézier curves from cusp to cusp. At a cusp both start outwards, off the radius by half the cusp's angle, and
// go straight on for a little, so the angle of the glass between them is the one drawn, also where curves are drawn as
// polygons; their handles are as long as the dagger is.
#include "glass/shards/hole_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/angle.h"
#include "core/functions.h"
#include "core/random.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"

namespace shatterpave::glass {

namespace {

using geometry::Polygon;
using geometry::Region;

// In photographs of broken windows: 6 to 12 arcs, cusps of 20 to 60° that reach in by 5 to 20 % of the hole's width.
constexpr int least_arcs = 6;
constexpr int greatest_arcs = 12;
constexpr Angle least_cusp = Angle::degrees(20.0);
constexpr Angle greatest_cusp = Angle::degrees(60.0);
constexpr double least_dagger = 0.05;
constexpr double greatest_dagger = 0.2;

// Of the root of the pane's area, for the ball and the speed of the paper: hole of a third of the pane's width. By eye.
constexpr double usual_share = 0.2;
constexpr double energy_power = 0.25;

// How far off even angles cusps are, as a share of the angle between two, and arcs off one distance. By eye.
// Two cusps stay a fifth of that angle apart, however these fall out.
constexpr double cusp_jitter = 0.3;
constexpr double greatest_snap = 0.1;
constexpr double arc_jitter = 0.16;
// Holes are longer one way than the other, by up to this. By eye.
constexpr double greatest_oval = 0.35;
// An arc whose handles have it cross another one is drawn flatter, so often and by so much.
constexpr int most_flattenings = 12;
constexpr double flattening = 0.8;
constexpr int arc_pieces = 14;
// Part of a handle that is straight.
constexpr double straight_share = 0.25;

// Teeth: how far apart, how wide and how high, in mm, and how many of them are left. The rebate of a frame holds 8 to 12 mm of
// the glass; by eye.
constexpr double tooth_pitch_mm = 26.0;
constexpr double least_tooth_mm = 4.0;
constexpr double greatest_tooth_mm = 22.0;
constexpr double teeth_left = 0.6;
constexpr double tooth_overlap_mm = 1.0;  // over the edge, so that cutting leaves nothing of it
constexpr double tooth_hollow = 0.35;  // how hollow the flanks are, as a share of the way from the middle of each to its foot
// A hole so many times as far as the farthest corner takes all.
constexpr double whole_pane = 2.0;

Angle angle_at(Angle low, Angle high, double share) { return low + share * (high - low); }

vec2 bezier(const std::array<vec2, 4>& c, double t) {
  const double s = 1.0 - t;
  return s * s * s * c[0] + 3.0 * s * s * t * c[1] + 3.0 * s * t * t * c[2] + t * t * t * c[3];
}

// Where radials of the pane cross the circle, in ascending order.
std::vector<double> crossings_of(const CrackNetwork& network, vec2 centre, double radius) {
  std::vector<double> directions;
  for (const Crack& crack : network.cracks) {
    for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
      const vec2 from = crack.points_mm[i - 1] - centre;
      const vec2 to = crack.points_mm[i] - centre;
      const bool out = glm::dot(from, from) < radius * radius && glm::dot(to, to) >= radius * radius;
      if (out) directions.push_back(Angle::of(to).radians());
    }
  }
  std::ranges::sort(directions);
  return directions;
}

// The middle of the strip between two cracks in which the direction lies.
double middle_of_strip(const std::vector<double>& cracks, double direction) {
  if (cracks.size() < 2) return direction;
  const double turns = std::floor(direction / (2.0 * pi));
  double within = direction - 2.0 * pi * turns;
  if (within >= pi) within -= 2.0 * pi;  // as Angle::of has it
  const auto above = std::ranges::upper_bound(cracks, within);
  const double high = above == cracks.end() ? cracks.front() + 2.0 * pi : *above;
  const double low = above == cracks.begin() ? cracks.back() - 2.0 * pi : *(above - 1);
  return direction - within + 0.5 * (low + high);
}

struct Cusp {
  double direction = 0.0;
  double radius_mm = 0.0;
  double depth_mm = 0.0;
  Angle angle;
  double skew = 0.5;  // how the two handles of the arc that it begins share their length
};

class Outline {
 public:
  Outline(const CrackNetwork& network, vec2 centre, double radius_mm, std::uint64_t seed, Id id)
      : centre_(centre), radius_mm_(radius_mm), seed_(seed), id_(id) {
    const int count = least_arcs + static_cast<int>(draw(0, 0) * draw(0, 10) * (greatest_arcs - least_arcs + 1));
    const std::vector<double> cracks = crossings_of(network, centre, radius_mm);
    const double first = 2.0 * pi * draw(0, 1);
    const double oval = greatest_oval * draw(0, 6);
    const double axis = pi * draw(0, 7);
    for (int k = 0; k < count; ++k) {
      const double even = first + 2.0 * pi * (k + cusp_jitter * (2.0 * draw(k, 2) - 1.0)) / count;
      const double middle = middle_of_strip(cracks, even);
      // Not so far that cusps crowd.
      const double most = greatest_snap * 2.0 * pi / count;
      Cusp cusp;
      cusp.direction = even + std::clamp(middle - even, -most, most);
      // Most daggers are short.
      cusp.depth_mm = 2.0 * radius_mm * (least_dagger + (greatest_dagger - least_dagger) * draw(k, 3) * draw(k, 8));
      const double reach = 1.0 + oval * cosine(2.0 * (cusp.direction - axis)) + arc_jitter * (2.0 * draw(k, 4) - 1.0);
      cusp.radius_mm = radius_mm * reach - 0.5 * cusp.depth_mm;
      cusp.skew = draw(k, 9);
      cusp.angle = angle_at(least_cusp, greatest_cusp, draw(k, 5));
      cusps_.push_back(cusp);
    }
  }

  Polygon polygon() const {
    double handles = 1.0;
    Polygon result = drawn(handles);
    for (int k = 0; k < most_flattenings && !geometry::is_simple(result); ++k) {
      handles *= flattening;
      result = drawn(handles);
    }
    return result;
  }

 private:
  double draw(int cusp, std::uint32_t number) const {
    return uniform(seed_, {Stream::hole_outline, id_.child(static_cast<std::uint64_t>(cusp)), number});
  }

  vec2 at(const Cusp& cusp) const { return centre_ + cusp.radius_mm * Angle::radians(cusp.direction).direction(); }

  Polygon drawn(double handles) const {
    Polygon result;
    for (std::size_t k = 0; k < cusps_.size(); ++k) {
      const std::array<vec2, 4> arc = arc_between(cusps_[k], cusps_[(k + 1) % cusps_.size()], handles);
      std::vector<vec2> points{arc[0]};
      const std::array<vec2, 4> curve = {glm::mix(arc[0], arc[1], straight_share), arc[1], arc[2],
                                         glm::mix(arc[3], arc[2], straight_share)};
      for (int i = 0; i <= arc_pieces; ++i) points.push_back(bezier(curve, static_cast<double>(i) / arc_pieces));
      for (const vec2& point : points) {
        const vec2 p = geometry::on_lattice(point);
        if (result.empty() || p != result.back()) result.push_back(p);
      }
    }
    return result;
  }

  // The middle of the curve lies three eighths of the sum of both handles beyond the middle of the chord.
  std::array<vec2, 4> arc_between(const Cusp& from, const Cusp& to, double handles) const {
    const vec2 a = at(from);
    const vec2 b = at(to);
    const double sag = 0.5 * (from.radius_mm + to.radius_mm) - glm::length(0.5 * (a + b) - centre_);
    const double both = handles * (0.5 * (from.depth_mm + to.depth_mm) + std::max(sag, 0.0)) / 0.375;
    const double share = 0.3 + 0.4 * from.skew;
    const vec2 out_a = (Angle::radians(from.direction) + 0.5 * from.angle).direction();
    const vec2 out_b = (Angle::radians(to.direction) - 0.5 * to.angle).direction();
    return {a, a + share * both * out_a, b + (1.0 - share) * both * out_b, b};
  }

  vec2 centre_;
  double radius_mm_;
  std::uint64_t seed_;
  Id id_;
  std::vector<Cusp> cusps_;
};

// A tooth on the edge about `foot`, `width` wide, that points along `in`: its flanks are hollow arcs.
Polygon tooth(vec2 foot, vec2 along, vec2 in, double width, double height, double lean) {
  const vec2 low = tooth_overlap_mm * in;
  const vec2 a = foot - 0.5 * width * along - low;
  const vec2 b = foot + 0.5 * width * along - low;
  const vec2 tip = foot + lean * width * along + height * in;
  const auto flank = [&](vec2 from, vec2 to, Polygon& polygon) {
    const vec2 hollow = glm::mix(0.5 * (from + to), foot, tooth_hollow);
    for (int i = 0; i < arc_pieces / 2; ++i) {
      const double t = 2.0 * i / arc_pieces;
      const double s = 1.0 - t;
      polygon.push_back(geometry::on_lattice(s * s * from + 2.0 * s * t * hollow + t * t * to));
    }
  };
  Polygon polygon{geometry::on_lattice(a)};
  flank(b, tip, polygon);
  flank(tip, a, polygon);
  return geometry::cleaned(polygon);
}

std::vector<Polygon> teeth_of(const Pane& pane, const std::vector<Region>& holes, std::uint64_t seed) {
  std::vector<Polygon> teeth;
  const Polygon& outline = pane.outline_mm;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const vec2 side = outline[(i + 1) % outline.size()] - outline[i];
    const double length = glm::length(side);
    const vec2 along = side / length;
    const auto count = static_cast<std::uint32_t>(std::max(std::floor(length / tooth_pitch_mm), 1.0));
    const double pitch = length / count;
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto draw = [&](std::uint32_t number) {
        return uniform(seed, {Stream::hole_outline, Id(pane.name).child("tooth").child(i).child(k), number});
      };
      const vec2 foot = outline[i] + pitch * (k + 0.3 + 0.4 * draw(0)) * along;
      const bool gone = std::ranges::any_of(holes, [&](const Region& hole) { return geometry::contains(hole, foot); });
      if (!gone || draw(1) >= teeth_left) continue;
      const double height = least_tooth_mm + (greatest_tooth_mm - least_tooth_mm) * draw(2) * draw(3);
      const double width = std::min(height * (0.8 + 1.6 * draw(4)), pitch);
      Polygon one = tooth(foot, along, left_of(along), width, height, 0.6 * draw(5) - 0.3);
      if (one.size() > 2) teeth.push_back(std::move(one));
    }
  }
  return teeth;
}

double farthest_mm(const Pane& pane, vec2 from) {
  double farthest = 0.0;
  for (const vec2& vertex : pane.outline_mm) farthest = std::max(farthest, glm::length(vertex - from));
  return farthest;
}

Region all_of(const Pane& pane) {
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  const vec2 low = geometry::on_lattice(box.low - vec2{tooth_overlap_mm, tooth_overlap_mm});
  const vec2 high = geometry::on_lattice(box.high + vec2{tooth_overlap_mm, tooth_overlap_mm});
  return {{low, {high.x, low.y}, high, {low.x, high.y}}, {}};
}

}  // namespace

double usual_missing_mm(const Pane& pane, const Impact& impact) {
  const Impact experiment;
  const double size = impact.ball_diameter_mm / experiment.ball_diameter_mm;
  const double speed = impact.speed_m_s / experiment.speed_m_s;
  return usual_share * std::sqrt(std::abs(geometry::area(pane.outline_mm))) *
         power(size * size * size * speed * speed, energy_power);
}

double hole_radius_mm(const Pane& pane, const Impact& impact) {
  if (impact.hole_mm > 0.0) return 0.5 * impact.hole_mm;
  const double reach = pane.shards->missing_mm.value_or(usual_missing_mm(pane, impact));
  return reach * std::sqrt(pane.shards->missing * 0.5 * std::sqrt(pi));
}

std::vector<Region> hole_outlines(const Pane& pane, const CrackNetwork& network, std::uint64_t seed) {
  std::vector<Polygon> outlines;
  for (std::size_t i = 0; i < pane.impacts.size(); ++i) {
    const Impact& impact = pane.impacts[i];
    const double radius = hole_radius_mm(pane, impact);
    if (radius <= 0.0) continue;
    if (radius > whole_pane * farthest_mm(pane, impact.at_mm)) return {all_of(pane)};
    const Id id = Id(pane.name).child("hole").child(i);
    outlines.push_back(Outline(network, impact.at_mm, radius, seed, id).polygon());
  }
  if (outlines.empty()) return {};
  std::vector<Region> holes = geometry::united(outlines);
  const std::vector<Polygon> teeth = teeth_of(pane, holes, seed);
  if (teeth.empty()) return holes;
  std::vector<Region> left;
  for (const Region& hole : holes) {
    // What teeth that meet part from the rest of the hole is no hole of its own: glass is left there.
    std::vector<Region> parts = geometry::difference(hole, teeth);
    const auto area = [](const Region& part) { return geometry::area(part); };
    if (!parts.empty()) left.push_back(std::move(*std::ranges::max_element(parts, {}, area)));
  }
  return left;
}

}  // namespace shatterpave::glass
