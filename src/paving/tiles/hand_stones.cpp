// Each side is moved at each of its ends by its own draw: outwards into the half joint that the stone owns, or inwards. Where a
// corner comes to lie follows from the ends that meet there. As far as a point may lie outside a face, a convex set is grown by
// it on all sides, and stays convex: with the corners in it all of the stone is in it.
#include "paving/tiles/hand_stones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/functions.h"
#include "geometry/clip.h"
#include "geometry/hull.h"
#include "geometry/lattice.h"
#include "geometry/segment_distance.h"

namespace shatterpave::paving {

namespace {

using geometry::Polygon;

// Standard deviation of ln(width) of half a joint at the end of a side, and how much its logarithm is less in the mean. Two
// halves add up, and widths along a side lie between those of its ends: by trial on all bonds, the width of the joint as a
// whole has a median of 92 to 102 % of `joint_mm`, and its logarithm a standard deviation of 0.5 to 0.6, as photographs
// measure.
constexpr double most_spread = 1.4;
constexpr double narrower = 0.45;
// Of half a joint: as near as stones come on purpose, and as far as filling holds.
constexpr double narrowest = 1.0 / 12.0;
constexpr double widest = 4.0;
// Of the shorter side at a corner: so a stone of a narrow course keeps its shape.
constexpr double most_inwards = 0.12;
// Corners turn by more than 20°, bends of sides by less; cosine.
constexpr double corner_cosine = 0.94;
// Of what `amount` says, where nothing else does: photographs have 5 to 15 %, by eye for the rest.
constexpr double usual_rounded = 0.1;
constexpr double usual_nibbled = 0.25;
constexpr double usual_sunk = 0.015;
constexpr double sunk_heights = 1.5;
// A nibbled corner has lost so much more on one of its sides; by eye.
constexpr double nibble = 2.2;
constexpr double most_cut_of_side = 0.45;

struct HandCorner {
  vec2 before{1.0, 0.0};  // along the side that ends here
  vec2 after{1.0, 0.0};
  double after_mm = 0.0;  // length of that
  double shorter_mm = 0.0;
  bool sharp = false;
  bool convex = false;
};

std::vector<HandCorner> stone_corners(const Polygon& outline) {
  const std::size_t n = outline.size();
  std::vector<HandCorner> corners(n);
  for (std::size_t i = 0; i < n; ++i) {
    const vec2 before = outline[i] - outline[(i + n - 1) % n];
    const vec2 after = outline[(i + 1) % n] - outline[i];
    HandCorner& corner = corners[i];
    corner.shorter_mm = std::min(glm::length(before), glm::length(after));
    corner.after_mm = glm::length(after);
    corner.before = before / glm::length(before);
    corner.after = after / glm::length(after);
    corner.sharp = glm::dot(corner.before, corner.after) < corner_cosine;
    corner.convex = cross(corner.before, corner.after) > 0.0;
  }
  return corners;
}

// From the outline to where the end of a side lies, outwards.
double outwards(const Pavement& pavement, double z) {
  const double amount = pavement.hand.amount;
  const double part = std::clamp(exponential(most_spread * amount * z - narrower * amount * amount), narrowest, widest);
  return 0.5 * pavement.joint_mm * (1.0 - part);
}

// Where a corner goes if the sides at it move outwards by `before` and `after`: no farther outside than `room_mm`.
vec2 step_of(const HandCorner& corner, double before, double after, double room_mm, bool nearly_convex) {
  const double turn = cross(corner.before, corner.after);
  // d · n₁ = before and d · n₂ = after, with n = the side turned to the right.
  vec2 step = (after * corner.before - before * corner.after) / turn;
  const double most = most_inwards * corner.shorter_mm;
  const double length = glm::length(step);
  if (length == 0.0) return step;
  const bool beyond = (before > 0.0 && glm::dot(step, corner.before) > 0.0) ||
                      (after > 0.0 && glm::dot(step, corner.after) < 0.0) || !nearly_convex;
  double limit = std::max(most, room_mm);
  if (beyond) limit = room_mm;
  if (!beyond && std::max(before, after) > room_mm) limit = std::min(limit, room_mm / std::max(before, after) * length);
  return length > limit ? limit / length * step : step;
}

// The same of a point where a side bends.
vec2 step_of_bend(const HandCorner& corner, double out, double room_mm, bool nearly_convex) {
  const vec2 normal = -left_of(corner.before + corner.after) / glm::length(corner.before + corner.after);
  const double most = nearly_convex ? most_inwards * corner.shorter_mm : room_mm;
  return std::clamp(out, -std::max(most, room_mm), room_mm) * normal;
}

// How deep the outline lies within its convex hull at the most.
double depth_of_pockets(const Polygon& outline) {
  const Polygon hull = geometry::convex_hull(outline);
  const auto is_on_hull = [&](vec2 p) { return std::ranges::find(hull, p) != hull.end(); };
  const std::size_t n = outline.size();
  const auto first = static_cast<std::size_t>(std::ranges::find_if(outline, is_on_hull) - outline.begin());
  double deepest = 0.0;
  std::vector<vec2> pocket;
  vec2 begin = outline[first % n];
  for (std::size_t k = 1; k <= n; ++k) {
    const vec2 p = outline[(first + k) % n];
    if (!is_on_hull(p)) {
      pocket.push_back(p);
      continue;
    }
    const double length = glm::length(p - begin);
    for (const vec2& q : pocket) deepest = std::max(deepest, std::abs(cross(p - begin, q - begin)) / length);
    pocket.clear();
    begin = p;
  }
  return deepest;
}

// How far the sides at a point move outwards there; of a point where a side bends both are the same.
struct SideEnds {
  double before = 0.0;
  double after = 0.0;
};

std::vector<SideEnds> side_ends(const std::vector<HandCorner>& corners, const Pavement& pavement, std::uint64_t seed,
                                Id stone) {
  const std::size_t n = corners.size();
  std::vector<SideEnds> ends(n);
  const auto end = [&](std::size_t corner, std::uint32_t index) {
    return outwards(pavement, normal(seed, {Stream::hand_corner, stone.child(corner), index}));
  };
  const auto first = static_cast<std::size_t>(std::ranges::find(corners, true, &HandCorner::sharp) - corners.begin());
  if (first == n) return ends;
  for (std::size_t begin = first; begin < first + n;) {
    std::size_t stop = begin + 1;
    double length = corners[begin % n].after_mm;
    for (; !corners[stop % n].sharp; ++stop) length += corners[stop % n].after_mm;
    const double from = end(begin % n, 1);
    const double to = end(stop % n, 0);
    ends[begin % n].after = from;
    ends[stop % n].before = to;
    double along = corners[begin % n].after_mm;
    for (std::size_t k = begin + 1; k < stop; ++k) {
      const double out = from + along / length * (to - from);
      ends[k % n] = {out, out};
      along += corners[k % n].after_mm;
    }
    begin = stop;
  }
  return ends;
}

// How far outside a convex polygon a point lies.
double distance_outside(const Polygon& hull, vec2 p) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = true;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const vec2 a = hull[i];
    const vec2 b = hull[(i + 1) % hull.size()];
    inside = inside && cross(b - a, p - a) >= 0.0;
    nearest = std::min(nearest, geometry::distance_to_segment(p, a, b));
  }
  return inside ? 0.0 : nearest;
}

// Takes back what would reach farther than `room_mm` out of the hull of the outline, within which all of the stone then is.
void hold_back(std::vector<vec2>& steps, const Polygon& outline, double room_mm) {
  const Polygon hull = geometry::convex_hull(outline);
  constexpr int most_halvings = 20;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    for (int k = 0; k <= most_halvings && distance_outside(hull, outline[i] + steps[i]) > room_mm; ++k) {
      steps[i] = k < most_halvings ? 0.5 * steps[i] : vec2{0.0, 0.0};
    }
  }
}

// The polygon in place of a corner that was cut off by those lengths along its sides: two points and one between them, on the
// parabola that touches both sides.
void append_rounded(vec2 at, const HandCorner& corner, double before_mm, double after_mm, Polygon& outline) {
  const vec2 first = at - before_mm * corner.before;
  const vec2 last = at + after_mm * corner.after;
  outline.push_back(first);
  outline.push_back(0.25 * first + 0.5 * at + 0.25 * last);
  outline.push_back(last);
}

Polygon with_round_corners(const Polygon& outline, const Pavement& pavement, std::uint64_t seed, Id stone) {
  const HandLaying& hand = pavement.hand;
  const double part = hand.rounded.value_or(usual_rounded * hand.amount);
  const double share = hand.nibbled.value_or(usual_nibbled * hand.amount);
  const auto draw = [&](std::size_t corner, std::uint32_t index) {
    return uniform(seed, {Stream::hand_corner, stone.child("round").child(corner), index});
  };
  if (part == 0.0 && share == 0.0) return outline;
  const std::vector<HandCorner> corners = stone_corners(outline);
  Polygon result;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const HandCorner& corner = corners[i];
    const double cut = corner.shorter_mm * part * (0.5 + draw(i, 0));
    double before = cut;
    double after = cut;
    if (draw(i, 1) < share) {
      // What is nibbled is so even where nothing is rounded.
      const double more = nibble * std::max(cut, 0.5 * usual_rounded * corner.shorter_mm);
      (draw(i, 2) < 0.5 ? before : after) = more;
      (draw(i, 2) < 0.5 ? after : before) = std::max(cut, 0.4 * more);
    }
    const double most = most_cut_of_side * corner.shorter_mm;
    if (!corner.sharp || !corner.convex || std::max(before, after) < 2.0 * narrowest) {
      result.push_back(outline[i]);
    } else {
      append_rounded(outline[i], corner, std::min(before, most), std::min(after, most), result);
    }
  }
  return result;
}

std::optional<Polygon> sound(Polygon outline) {
  for (vec2& p : outline) p = geometry::on_lattice(p);
  outline = geometry::cleaned(outline);
  if (outline.size() < 3 || !geometry::is_simple(outline) || geometry::area(outline) <= 0.0) return std::nullopt;
  return outline;
}

}  // namespace

Polygon hand_face(const Polygon& outline, const Pavement& pavement, double room_mm, std::uint64_t seed, Id stone) {
  const std::vector<HandCorner> corners = stone_corners(outline);
  const double pockets_mm = depth_of_pockets(outline);
  const bool nearly_convex = pockets_mm < 0.5 * room_mm || pockets_mm == 0.0;
  if (nearly_convex) room_mm -= pockets_mm;
  const std::vector<SideEnds> ends = side_ends(corners, pavement, seed, stone);
  std::vector<vec2> steps(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    steps[i] = corners[i].sharp ? step_of(corners[i], ends[i].before, ends[i].after, room_mm, nearly_convex)
                                : step_of_bend(corners[i], ends[i].after, room_mm, nearly_convex);
  }
  if (nearly_convex) hold_back(steps, outline, room_mm);
  constexpr int most_halvings = 4;
  double part = 1.0;
  for (int halving = 0; halving < most_halvings; ++halving, part *= 0.5) {
    Polygon moved(outline.size());
    for (std::size_t i = 0; i < outline.size(); ++i) moved[i] = outline[i] + part * steps[i];
    const auto result = sound(std::move(moved));
    if (!result) continue;
    return sound(with_round_corners(*result, pavement, seed, stone)).value_or(*result);
  }
  return outline;
}

double sunk_mm(const Pavement& pavement, std::uint64_t seed, Id stone) {
  const HandLaying& hand = pavement.hand;
  const double share = hand.sunk.value_or(usual_sunk * hand.amount);
  if (uniform(seed, {Stream::stone_hollow, stone, 0}) >= share) return 0.0;
  const double most = hand.sunk_mm.value_or(sunk_heights * pavement.surface.height_mm);
  return std::round(1000.0 * most * (0.4 + 0.6 * uniform(seed, {Stream::stone_hollow, stone, 1}))) / 1000.0;
}

}  // namespace shatterpave::paving
