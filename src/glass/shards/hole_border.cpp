// Arcs are cubic Bézier curves from corner to corner, with half the handles that Hobby gives smooth curves (Smooth, Easy to
// Compute Interpolating Splines, 1986). At a cusp they go straight on for a little, so the angle of the glass there is the one
// drawn, also where curves are drawn as polygons. The flank along a crack is the crack itself: pieces end half a gap beside it,
// so no splinter is left of the one that has gone.
#include "glass/shards/hole_border.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/angle.h"
#include "core/functions.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"

namespace shatterpave::glass {

namespace {

using geometry::Polygon;

// In photographs of broken windows: 6 to 12 arcs, cusps of 20 to 60° that reach in by 5 to 20 % of the hole's width.
constexpr int least_arcs = 6;
constexpr int greatest_arcs = 12;
constexpr Angle least_cusp = Angle::degrees(20.0);
constexpr Angle greatest_cusp = Angle::degrees(60.0);
constexpr double least_flank = 0.09;  // of the hole's width: a cusp's flank; its arc has the rest
constexpr double greatest_flank = 0.22;
constexpr double greatest_crack_flank = 0.15;

// All that follows by eye, beside photographs.
// The narrowest arc, as a share of the widest; and how far a cusp may go to a radial, as a share of the narrower arc beside it.
constexpr double narrowest = 0.3;
constexpr double greatest_snap = 0.35;
// Part of the cusps near radials of which a flank is the radial.
constexpr double along_cracks = 0.85;
// A flank that is no crack is no longer than this share of the narrower arc beside it, and hangs over by this at the most.
constexpr double longest_flank = 0.8;
constexpr Angle greatest_overhang = Angle::degrees(8.0);
// At its ends an arc bulges from the way between them, as a share of what a circle about the impact does, and a little more.
constexpr double least_bulge = 0.0;
constexpr double greatest_bulge = 0.7;
constexpr Angle more_bulge = Angle::degrees(4.0);
// By so much the outline turns at the foot of a flank.
constexpr Angle least_shoulder = Angle::degrees(30.0);
constexpr Angle greatest_shoulder = Angle::degrees(110.0);
// Farther than this off the way from the impact a crack makes no flank.
constexpr Angle greatest_slant = Angle::degrees(28.0);
constexpr Angle greatest_kink = Angle::degrees(25.0);
// The foot of a flank that is no crack is rounded over this share of the flank.
constexpr double rounded_share = 0.15;
constexpr int rounding_pieces = 6;
// Cusps are off one distance by up to this share, and holes longer one way than the other.
constexpr double reach_jitter = 0.2;
constexpr double greatest_oval = 0.3;
// Cusps stand nearer than a disc of the same size is wide.
constexpr double tip_share = 0.9;

// An outline that would cross itself is drawn with flatter arcs and shorter flanks, so often and by so much.
constexpr int most_flattenings = 12;
constexpr double flattening = 0.8;
// One that is drawn smaller than this follows no crack.
constexpr double least_along_cracks = 0.6;
constexpr int arc_pieces = 16;
constexpr double straight_share = 0.25;  // part of a handle that is straight
// Handles are so much shorter than those of smooth curves: broken edges run nearly straight and bend near their ends.
constexpr double shorter_handles = 0.5;

Angle angle_at(Angle low, Angle high, double share) { return low + share * (high - low); }

vec2 bezier(const std::array<vec2, 4>& c, double t) {
  const double s = 1.0 - t;
  return s * s * s * c[0] + 3.0 * s * s * t * c[1] + 3.0 * s * t * t * c[2] + t * t * t * c[3];
}

// Length of a handle as a share of the chord, where the curve leaves it by one angle and comes back by the other.
double handle_share(Angle here, Angle there) {
  const auto [sine_h, cosine_h] = sine_and_cosine(here.radians());
  const auto [sine_t, cosine_t] = sine_and_cosine(there.radians());
  const double above = 2.0 + std::sqrt(2.0) * (sine_h - sine_t / 16.0) * (sine_t - sine_h / 16.0) * (cosine_h - cosine_t);
  const double below = 1.0 + 0.5 * (std::sqrt(5.0) - 1.0) * cosine_h + 0.5 * (3.0 - std::sqrt(5.0)) * cosine_t;
  return above / (3.0 * below);
}

// Where a radial crosses a circle about the impact.
struct Crossing {
  double direction = 0.0;  // within (-π, π]
  const Crack* crack = nullptr;
};

// In ascending order.
std::vector<Crossing> crossings_of(const CrackNetwork& network, vec2 centre, double radius) {
  std::vector<Crossing> crossings;
  for (const Crack& crack : network.cracks) {
    if (crack.kind != CrackKind::large && crack.kind != CrackKind::radial && crack.kind != CrackKind::branch) continue;
    for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
      const vec2 from = crack.points_mm[i - 1] - centre;
      const vec2 to = crack.points_mm[i] - centre;
      const bool out = glm::dot(from, from) < radius * radius && glm::dot(to, to) >= radius * radius;
      if (out) crossings.push_back({Angle::of(to).radians(), &crack});
    }
  }
  std::ranges::sort(crossings, {}, &Crossing::direction);
  return crossings;
}

// From -π to π.
double from_to(double other, double direction) {
  return (Angle::radians(direction) - Angle::radians(other)).wrapped().radians();
}

// Where side `i` of the crack, from point i - 1 to point i, leaves a circle about the centre.
vec2 leaving(const Crack& crack, std::size_t i, vec2 centre, double distance_mm) {
  const vec2 a = crack.points_mm[i - 1] - centre;
  const vec2 way = crack.points_mm[i] - crack.points_mm[i - 1];
  const double half = glm::dot(a, way) / glm::dot(way, way);
  const double rest = (glm::dot(a, a) - distance_mm * distance_mm) / glm::dot(way, way);
  return geometry::on_lattice(crack.points_mm[i - 1] + (std::sqrt(std::max(half * half - rest, 0.0)) - half) * way);
}

bool is_within(Angle angle, Angle limit) { return angle <= limit && angle >= -limit; }

// The part of the crack between two distances from the centre, from the inner to the outer; nothing where it does not run
// outwards all the way.
std::optional<std::vector<vec2>> flank_along(const Crack& crack, vec2 centre, double from_mm, double to_mm) {
  std::vector<vec2> flank;
  Angle before;
  const auto add = [&](vec2 point) {
    if (flank.empty() || point != flank.back()) flank.push_back(point);
  };
  for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
    const vec2 a = crack.points_mm[i - 1] - centre;
    const vec2 b = crack.points_mm[i] - centre;
    if (flank.empty() && (glm::length(a) >= from_mm || glm::length(b) < from_mm)) continue;
    const Angle on = Angle::of(b - a);
    if (!is_within((on - Angle::of(0.5 * (a + b))).wrapped(), greatest_slant)) return std::nullopt;
    if (flank.size() > 1 && !is_within((on - before).wrapped(), greatest_kink)) return std::nullopt;
    before = on;
    if (flank.empty()) add(leaving(crack, i, centre, from_mm));
    if (glm::length(b) >= to_mm) {
      add(leaving(crack, i, centre, to_mm));
      return flank.size() < 2 ? std::nullopt : std::optional(flank);
    }
    add(crack.points_mm[i]);
  }
  return std::nullopt;
}

// Where glass points into the hole.
struct Cusp {
  vec2 tip{0.0, 0.0};
  std::vector<vec2> flank;  // along a crack, outwards; or empty
};

// Between two arcs.
struct Corner {
  std::vector<vec2> points;  // from the end of the arc before to the start of the one behind
  Angle before;              // in which direction, from its end there, the arc before goes
  Angle behind;
};

class Border {
 public:
  Border(const CrackNetwork& network, vec2 centre, double radius_mm, std::uint64_t seed, Id id)
      : centre_(centre), radius_mm_(radius_mm), seed_(seed), id_(id), crossings_(crossings_of(network, centre, radius_mm)) {
    const auto count = static_cast<std::size_t>(least_arcs + draw(0, 0) * (greatest_arcs - least_arcs + 1));
    std::vector<double> widths;
    double all = 0.0;
    widths.reserve(count);
    for (std::size_t k = 0; k < count; ++k) all += widths.emplace_back(narrowest + (1.0 - narrowest) * draw(k, 1));
    double direction = 2.0 * pi * draw(0, 2);
    for (std::size_t k = 0; k < count; ++k) {
      const double before = 2.0 * pi / all * widths[(k + count - 1) % count];
      const double behind = 2.0 * pi / all * widths[k];
      cusps_.push_back(cusp_at(k, direction, greatest_snap * std::min(before, behind)));
      direction += behind;
    }
  }

  Polygon polygon() const {
    double size = 1.0;
    Polygon result = drawn(size);
    for (int round = 0; round < most_flattenings && !geometry::is_simple(result); ++round) {
      size *= flattening;
      result = drawn(size);
    }
    return result;
  }

 private:
  double draw(std::size_t corner, std::uint32_t number) const {
    return uniform(seed_, {Stream::hole_outline, id_.child(corner), number});
  }

  // How far from the centre the cusp of the corner is, were it in that direction.
  double tip_mm(std::size_t k, double direction) const {
    const double oval = greatest_oval * draw(0, 3) * cosine(2.0 * (direction - pi * draw(0, 4)));
    return tip_share * radius_mm_ * (1.0 + oval + reach_jitter * (2.0 * draw(k, 5) - 1.0));
  }

  Angle bulge(std::size_t k, std::uint32_t number, vec2 from, vec2 to) const {
    const double width = std::abs(from_to(Angle::of(from - centre_).radians(), Angle::of(to - centre_).radians()));
    return more_bulge + (least_bulge + (greatest_bulge - least_bulge) * draw(k, number)) * Angle::radians(0.5 * width);
  }

  Cusp cusp_at(std::size_t k, double direction, double most_off) const {
    const auto off = [&](const Crossing& crossing) { return std::abs(from_to(direction, crossing.direction)); };
    const auto nearest = std::ranges::min_element(crossings_, {}, off);
    if (nearest != crossings_.end() && off(*nearest) < most_off && draw(k, 10) < along_cracks) {
      const double from_mm = tip_mm(k, nearest->direction);
      const double length_mm = 2.0 * radius_mm_ * (least_flank + (greatest_crack_flank - least_flank) * draw(k, 6));
      if (auto flank = flank_along(*nearest->crack, centre_, from_mm, from_mm + length_mm)) return {flank->front(), *flank};
    }
    const double at = std::clamp(middle_of_strip(direction), direction - most_off, direction + most_off);
    return {geometry::on_lattice(centre_ + tip_mm(k, at) * Angle::radians(at).direction()), {}};
  }

  // The cusp lies between an arc, which comes to its tip, and its flank, at whose foot the other arc begins. Seen from the tip,
  // the arc comes from the side `turn`, 1 being counter-clockwise.
  //   size  of what is free of it, a share
  Corner corner_of(std::size_t k, double size) const {
    const std::size_t n = cusps_.size();
    const Cusp& cusp = cusps_[k];
    const double turn = draw(k, 9) < 0.5 ? 1.0 : -1.0;
    const vec2 arc_side = cusps_[(turn > 0.0 ? k + 1 : k + n - 1) % n].tip;
    const vec2 flank_side = cusps_[(turn > 0.0 ? k + n - 1 : k + 1) % n].tip;
    const Angle angle = angle_at(least_cusp, greatest_cusp, draw(k, 7));
    std::vector<vec2> flank = size > least_along_cracks ? cusp.flank : std::vector<vec2>();
    const bool is_free = flank.empty();
    Angle arc;
    if (!is_free) {
      arc = Angle::of(flank[1] - flank[0]) + turn * angle;
    } else {
      const Angle out = Angle::of(cusp.tip - centre_);
      const Angle bulging = Angle::of(arc_side - cusp.tip) - turn * bulge(k, 8, cusp.tip, arc_side);
      const Angle off = turn * (bulging - out).wrapped();
      arc = out + turn * std::min(off, angle + greatest_overhang);
      const double narrower_mm = std::min(glm::length(arc_side - cusp.tip), glm::length(flank_side - cusp.tip));
      const double length_mm = 2.0 * radius_mm_ * (least_flank + (greatest_flank - least_flank) * draw(k, 6));
      flank = {cusp.tip, cusp.tip + size * std::min(length_mm, longest_flank * narrower_mm) * (arc - turn * angle).direction()};
    }
    // At the foot the outline turns to the other arc by less than half a turn.
    const Angle on = Angle::of(flank.back() - flank[flank.size() - 2]);
    const Angle straight = Angle::of(flank_side - flank.back()) + turn * bulge(k, 11, flank.back(), flank_side);
    Angle off = turn * (on - straight).wrapped();
    if (off < Angle()) off = greatest_shoulder;
    const Angle other = on - turn * std::clamp(off, least_shoulder, greatest_shoulder);
    if (is_free) round_off_foot(flank, other);
    if (turn > 0.0) {
      std::ranges::reverse(flank);
      return {std::move(flank), other, arc};
    }
    return {std::move(flank), arc, other};
  }

  static void round_off_foot(std::vector<vec2>& flank, Angle on) {
    const vec2 foot = flank.back();
    const vec2 from = glm::mix(foot, flank.front(), rounded_share);
    const vec2 to = foot + glm::length(foot - from) * on.direction();
    flank.pop_back();
    for (int i = 0; i <= rounding_pieces; ++i) {
      const double t = static_cast<double>(i) / rounding_pieces;
      flank.push_back(glm::mix(glm::mix(from, foot, t), glm::mix(foot, to, t), t));
    }
  }

  // The middle of the strip between two cracks in which the direction lies.
  double middle_of_strip(double direction) const {
    if (crossings_.size() < 2) return direction;
    double low = -2.0 * pi;
    double high = 2.0 * pi;
    for (const Crossing& crossing : crossings_) {
      const double off = from_to(direction, crossing.direction);
      low = std::max(low, off > 0.0 ? off - 2.0 * pi : off);
      high = std::min(high, off > 0.0 ? off : off + 2.0 * pi);
    }
    return direction + 0.5 * (low + high);
  }

  Polygon drawn(double size) const {
    std::vector<Corner> corners;
    corners.reserve(cusps_.size());
    for (std::size_t k = 0; k < cusps_.size(); ++k) corners.push_back(corner_of(k, size));
    Polygon result;
    const auto add = [&](vec2 point) {
      const vec2 p = geometry::on_lattice(point);
      if (result.empty() || (p != result.back() && p != result.front())) result.push_back(p);
    };
    for (std::size_t k = 0; k < corners.size(); ++k) {
      for (const vec2& point : corners[k].points) add(point);
      const std::array<vec2, 4> arc = arc_between(corners[k], corners[(k + 1) % corners.size()], size);
      const std::array<vec2, 4> curve = {glm::mix(arc[0], arc[1], straight_share), arc[1], arc[2],
                                         glm::mix(arc[3], arc[2], straight_share)};
      for (int i = 0; i <= arc_pieces; ++i) add(bezier(curve, static_cast<double>(i) / arc_pieces));
    }
    return result;
  }

  static std::array<vec2, 4> arc_between(const Corner& from, const Corner& to, double handles) {
    const vec2 a = from.points.back();
    const vec2 b = to.points.front();
    const Angle chord = Angle::of(b - a);
    const Angle at_a = (chord - from.behind).wrapped();
    const Angle at_b = (to.before - Angle::of(a - b)).wrapped();
    const double length = shorter_handles * handles * glm::length(b - a);
    return {a, a + length * handle_share(at_a, at_b) * from.behind.direction(),
            b + length * handle_share(at_b, at_a) * to.before.direction(), b};
  }

  vec2 centre_;
  double radius_mm_;
  std::uint64_t seed_;
  Id id_;
  std::vector<Crossing> crossings_;
  std::vector<Cusp> cusps_;
};

}  // namespace

Polygon hole_border(const CrackNetwork& network, vec2 centre, double radius_mm, std::uint64_t seed, Id id) {
  return Border(network, centre, radius_mm, seed, id).polygon();
}

}  // namespace shatterpave::glass
