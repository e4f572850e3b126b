// Heights are z = f + G (domed_patch.h), with G the face and f the arris, 0 on the face and −rise at the outline.
//
// The rounded arris is the shoulder of stone_surface.cpp: across it the control heights of f are −rise, 0, 0, 0, at corners the
// product of both sides. A chip lowers the second of them along a part of a side, from rows that are as they were to rows that
// are lowered and back, so tangent planes along all borders stay what they are. A face with chips, or with other than four
// sides, is a fan about its middle; where a chip divides a side, the fan is divided from that side to the opposite one.
#include "paving/surface/stone_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/functions.h"
#include "paving/surface/domed_patch.h"
#include "paving/surface/stone_pieces.h"

namespace shatterpave::paving {

using geometry::BezierPatch;
using geometry::Polygon;

namespace {

using Quad = std::array<vec2, 4>;

// ---- the face

// |q|² of the corners, q as below, is at most 8/3, in a triangle.
constexpr double farthest2 = 8.0 / 3.0;

// In coordinates q of the stone in which its second moments are 1/3 along all directions, as those of a square of half width 1:
// crown (1 − |q|²) + warp.x (q₁² − q₂²) + warp.y 2 q₁ q₂, and the tilt.
struct Face {
  vec2 centre{0.0, 0.0};
  double crown = 0.0;
  vec2 slope{0.0, 0.0};
  double xx = 0.0, xy = 0.0, yy = 0.0;

  double blossom(vec2 p, vec2 q) const {
    const vec2 a = p - centre;
    const vec2 b = q - centre;
    return crown + 0.5 * glm::dot(slope, a + b) + xx * a.x * b.x + xy * (a.x * b.y + a.y * b.x) + yy * a.y * b.y;
  }
};

struct Moments {
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

// Second moments about `centre` over the area.
Moments moments(const Polygon& polygon, vec2 centre) {
  Moments sum;
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const vec2 a = polygon[i] - centre;
    const vec2 b = cyclic(polygon, i + 1) - centre;
    const double twice = cross(a, b);
    area += 0.5 * twice;
    sum.xx += twice * (a.x * a.x + a.x * b.x + b.x * b.x) / 12.0;
    sum.yy += twice * (a.y * a.y + a.y * b.y + b.y * b.y) / 12.0;
    sum.xy += twice * (2.0 * a.x * a.y + a.x * b.y + a.y * b.x + 2.0 * b.x * b.y) / 24.0;
  }
  return {sum.xx / area, sum.xy / area, sum.yy / area};
}

Face face_of(const Polygon& polygon, const BodyDraws& draws) {
  Face face;
  face.centre = geometry::centroid(polygon);
  face.crown = draws.crown_mm;
  double reach = 0.0;
  for (const vec2& p : polygon) reach = std::max(reach, std::abs(glm::dot(draws.slope, p - face.centre)));
  face.slope = reach > draws.tilt_room_mm ? draws.tilt_room_mm / reach * draws.slope : draws.slope;
  // q = S (p − centre), with S the inverse of the root of three times the moments: (M + √det M) / √(trace M + 2 √det M) is √M.
  const Moments m = moments(polygon, face.centre);
  const double root = std::sqrt(std::max(0.0, m.xx * m.yy - m.xy * m.xy));
  const double scale = 1.0 / (std::sqrt(3.0 * (m.xx + m.yy + 2.0 * root)) * root);
  const double sxx = scale * (m.yy + root);
  const double syy = scale * (m.xx + root);
  const double sxy = -scale * m.xy;
  const double a = draws.warp_mm.x - draws.crown_mm;
  const double b = draws.warp_mm.y;
  const double c = -draws.warp_mm.x - draws.crown_mm;
  face.xx = a * sxx * sxx + 2.0 * b * sxx * sxy + c * sxy * sxy;
  face.xy = a * sxx * sxy + b * (sxx * syy + sxy * sxy) + c * sxy * syy;
  face.yy = a * sxy * sxy + 2.0 * b * sxy * syy + c * syy * syy;
  return face;
}

// ---- arrises in the plane

// An arris of a sawn side, mm: what EN 1341 calls sharp.
constexpr double sawn_arris_mm = 1.5;
constexpr double used_of_feasible = 0.8;     // of the width at which a side would be used up
constexpr double least_part_of_width = 0.5;  // of the asked width, below which corners are left out
constexpr double least_of_size = 0.03;       // of the stone's size; narrower arrises are taken as they come

vec2 along(const Polygon& polygon, std::size_t i) { return glm::normalize(cyclic(polygon, i + 1) - cyclic(polygon, i)); }

// The inner line of strips of those widths along the sides.
Polygon inset(const Polygon& polygon, const std::vector<double>& widths) {
  const std::size_t count = polygon.size();
  Polygon inner(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double sine_of_turn = corner_sine(polygon, i);
    inner[i] = polygon[i] + widths[(i + count - 1) % count] / sine_of_turn * along(polygon, i) -
               widths[i] / sine_of_turn * along(polygon, i + count - 1);
  }
  return inner;
}

// The factor on the widths with which they leave something of every side, on the outline and on the inner line.
double feasible_part(const Polygon& polygon, const std::vector<double>& widths) {
  const std::size_t count = polygon.size();
  double part = 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const double length = glm::length(polygon[next] - polygon[i]);
    const double here = corner_sine(polygon, i);
    const double there = corner_sine(polygon, next);
    const double outer = widths[(i + count - 1) % count] / here + widths[next] / there;
    const double inner = outer - widths[i] * (corner_cosine(polygon, i) / here + corner_cosine(polygon, next) / there);
    const double used = std::max(outer, inner);
    if (used > 0.0) part = std::min(part, used_of_feasible * length / used);
  }
  return part;
}

struct Ring {
  Polygon outline;
  std::vector<bool> sawn;      // sides
  std::vector<double> widths;  // of the arrises
};

Ring ring_of(Polygon outline, const BodyDraws& draws, const IsSawn& is_sawn) {
  const double size = std::sqrt(geometry::area(outline));
  Ring ring;
  for (;;) {
    ring.sawn.clear();
    ring.widths.clear();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const bool sawn = is_sawn && is_sawn(outline[i], cyclic(outline, i + 1));
      ring.sawn.push_back(sawn);
      ring.widths.push_back(sawn ? std::min(draws.arris_mm, sawn_arris_mm) : draws.arris_mm);
    }
    const double part = feasible_part(outline, ring.widths);
    const bool too_narrow = part < least_part_of_width && part * draws.arris_mm < least_of_size * size;
    if (outline.size() > 4 && too_narrow) {
      leave_out_least_corner(outline);
      continue;
    }
    for (double& width : ring.widths) width *= part;
    ring.outline = std::move(outline);
    return ring;
  }
}

// ---- chips

constexpr double least_chip_mm = 5.0;  // half its length along the side; by eye, as is the next
constexpr double most_chip_mm = 16.0;
constexpr double longest_part = 0.85;  // of the half side that a half of it lies on

struct Side {
  bool chipped = false;
  double split = 0.5;            // where the fan meets the side, and the middle of the chip
  double depth = 0.0;            // by how much f is lowered, as a part of the rise
  std::array<double, 2> ends{};  // of the chip: where it begins on the first half, where it ends on the second one
};

// To steps of 1/1024, so that what is one place counted from either end is one number.
double in_steps(double part) { return std::max(1.0, std::floor(1024.0 * part)) / 1024.0; }

std::vector<Side> sides_of(const Ring& ring, const Polygon& face, const BodyDraws& draws) {
  std::vector<Side> sides(face.size());
  for (std::size_t i = 0; i < std::min(sides.size(), draws.chips.size()); ++i) {
    const ChipDraws& chip = draws.chips[i];
    const double length = glm::length(cyclic(face, i + 1) - face[i]);
    if (ring.sawn[i] || chip.chance >= 0.001 * draws.chips_per_m * length) continue;
    Side& side = sides[i];
    side.chipped = true;
    side.split = 0.25 + 0.5 * chip.place;
    side.depth = 0.3 + 0.6 * chip.size;
    const double half_mm = least_chip_mm + (most_chip_mm - least_chip_mm) * chip.size;
    side.ends = {1.0 - in_steps(std::min(longest_part, half_mm / (side.split * length))),
                 in_steps(std::min(longest_part, half_mm / ((1.0 - side.split) * length)))};
  }
  return sides;
}

// ---- patches

Quad part_of(const Quad& quad, vec2 u, vec2 v) {
  return {bilinear(quad, u.x, v.x), bilinear(quad, u.y, v.x), bilinear(quad, u.y, v.y), bilinear(quad, u.x, v.y)};
}

class BodyBuilder {
 public:
  BodyBuilder(Ring ring, const BodyDraws& draws)
      : ring_(std::move(ring)),
        rim_(ring_.outline),
        draws_(draws),
        face_(face_of(ring_.outline, draws)),
        count_(ring_.outline.size()) {}

  std::vector<BezierPatch> rounded() {
    const std::vector<double> whole = widened(stands_free() ? steep_mm : 0.0);
    const double part = stands_free() ? std::min(1.0, feasible_part(ring_.outline, whole)) : 1.0;
    if (stands_free()) {
      rim_ = inset(ring_.outline, std::vector<double>(count_, part * steep_mm));
      for (double& w : ring_.widths) w *= part;
    }
    const Polygon& outline = rim_;
    const Polygon crown = inset(outline, ring_.widths);
    sides_ = sides_of(ring_, crown, draws_);
    fan_ = count_ != 4 || std::ranges::any_of(sides_, &Side::chipped);
    for (std::size_t i = 0; i < count_; ++i) {
      const vec2 arriving = outline[i] - width(i) / corner_sine(outline, i) * along(outline, i + count_ - 1);
      add({outline[i], leaving(i), crown[i], arriving},
          [&](std::size_t row, std::size_t column) { return row == 0 || column == 0 ? draws_.flank_mm : draws_.rise_mm; });
      add_flank((i + count_ - 1) % count_, arriving, outline[i]);
      add_flank(i, outline[i], leaving(i));
      const std::size_t next = (i + 1) % count_;
      const vec2 far = outline[next] - width(next) / corner_sine(outline, next) * along(outline, i);
      add_side(i, {leaving(i), far, crown[next], crown[i]});
    }
    add_face(crown);
    return std::move(patches_);
  }

  std::vector<BezierPatch> chamfered() {
    const double part = std::min(1.0, feasible_part(ring_.outline, widened(steep_mm)));
    std::vector<double> outer(count_, part * steep_mm);
    std::vector<double> whole = widened(steep_mm);
    for (double& w : whole) w *= part;
    const Polygon edge = inset(ring_.outline, outer);
    const Polygon crown = inset(ring_.outline, whole);
    sides_.assign(count_, {});
    fan_ = count_ != 4;
    // At 45°, if the stone is high enough.
    const double drop = std::min(*std::ranges::max_element(ring_.widths), 0.9 * draws_.rise_mm);
    for (std::size_t i = 0; i < count_; ++i) {
      const std::size_t next = (i + 1) % count_;
      add_strip({ring_.outline[i], ring_.outline[next], edge[next], edge[i]}, 0.0, draws_.rise_mm - drop);
      add_strip({edge[i], edge[next], crown[next], crown[i]}, draws_.rise_mm - drop, draws_.rise_mm);
    }
    add_face(crown);
    return std::move(patches_);
  }

 private:
  // Below a chamfer, and below the arris of what stands free, a side is as steep as a strip of this width makes it.
  static constexpr double steep_mm = 0.3;

  double width(std::size_t i) const { return ring_.widths[i]; }
  vec2 leaving(std::size_t i) const {
    return rim_[i] + width((i + count_ - 1) % count_) / corner_sine(rim_, i) * along(rim_, i);
  }
  bool stands_free() const { return draws_.flank_mm > 0.0; }
  // The steep part of side i below the part of the arris from `a` to `b`, which lie on the rim.
  void add_flank(std::size_t i, vec2 a, vec2 b) {
    if (!stands_free()) return;
    const vec2 from = rim_[i];
    const vec2 side = cyclic(rim_, i + 1) - from;
    const auto below = [&](vec2 p) {
      const double place = glm::dot(p - from, side) / glm::dot(side, side);
      return ring_.outline[i] + place * (cyclic(ring_.outline, i + 1) - ring_.outline[i]);
    };
    add({below(a), below(b), b, a},
        [&](std::size_t, std::size_t column) { return draws_.flank_mm * static_cast<double>(column) / 3.0; });
  }
  std::vector<double> widened(double by) const {
    std::vector<double> widths = ring_.widths;
    for (double& w : widths) w += by;
    return widths;
  }

  template <typename Shoulder>
  void add(const Quad& quad, const Shoulder& shoulder) {
    patches_.push_back(domed_patch(quad, face_, shoulder));
  }

  // The places that divide the first half of side i, and with it, through the fan, the second half of the side before the last.
  std::vector<double> divisions(std::size_t i) const {
    std::vector<double> places = {0.0};
    const Side& across = sides_[(i + count_ - 2) % count_];
    if (sides_[i].chipped) places.push_back(sides_[i].ends[0]);
    if (across.chipped) places.push_back(1.0 - across.ends[1]);
    places.push_back(1.0);
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  }
  std::vector<double> divisions_of_second(std::size_t i) const {
    std::vector<double> places = divisions((i + 2) % count_);
    std::ranges::reverse(places);
    for (double& place : places) place = 1.0 - place;
    return places;
  }

  // A side's part of the ring: whole beside a face of one patch, else in two halves that are divided as the fan is.
  void add_side(std::size_t i, const Quad& quad) {
    const auto plain = [&](std::size_t, std::size_t column) { return column == 0 ? draws_.flank_mm : draws_.rise_mm; };
    if (!fan_) {
      add(quad, plain);
      add_flank(i, quad[0], quad[1]);
      return;
    }
    const Side& side = sides_[i];
    const auto add_half = [&](const Quad& half, const std::vector<double>& places, const auto& is_lowered) {
      for (std::size_t k = 0; k + 1 < places.size(); ++k) {
        const std::array<bool, 2> lowered = {is_lowered(places[k]), is_lowered(places[k + 1])};
        const Quad part = part_of(half, {places[k], places[k + 1]}, {0.0, 1.0});
        add_arris(part, side.depth, lowered);
        add_flank(i, part[0], part[1]);
      }
    };
    add_half(part_of(quad, {0.0, side.split}, {0.0, 1.0}), divisions(i),
             [&](double place) { return side.chipped && place > side.ends[0]; });
    add_half(part_of(quad, {side.split, 1.0}, {0.0, 1.0}), divisions_of_second(i),
             [&](double place) { return side.chipped && place < side.ends[1]; });
  }

  // A part of the ring of which either end may be lowered by a chip: two rows each, so that it is level there.
  void add_arris(const Quad& quad, double depth, std::array<bool, 2> lowered) {
    add(quad, [&](std::size_t row, std::size_t column) {
      if (column == 0) return draws_.flank_mm;
      const bool is_low = column == 1 && lowered[row / 2];
      return is_low ? draws_.rise_mm - depth * (draws_.rise_mm - draws_.flank_mm) : draws_.rise_mm;
    });
  }

  // A strip along a side with f from `outer` to `inner`.
  void add_strip(const Quad& quad, double outer, double inner) {
    const auto linear = [&](std::size_t, std::size_t column) {
      return outer + (inner - outer) * static_cast<double>(column) / 3.0;
    };
    if (!fan_) {
      add(quad, linear);
      return;
    }
    add(part_of(quad, {0.0, 0.5}, {0.0, 1.0}), linear);
    add(part_of(quad, {0.5, 1.0}, {0.0, 1.0}), linear);
  }

  void add_face(const Polygon& crown) {
    const auto level = [&](std::size_t, std::size_t) { return draws_.rise_mm; };
    if (!fan_) {
      add({crown[0], crown[1], crown[2], crown[3]}, level);
      return;
    }
    const vec2 middle = geometry::centroid(crown);
    const auto split = [&](std::size_t i) { return crown[i] + sides_[i].split * (cyclic(crown, i + 1) - crown[i]); };
    for (std::size_t i = 0; i < count_; ++i) {
      const Quad quad = {crown[i], split(i), middle, split((i + count_ - 1) % count_)};
      const std::vector<double> us = divisions(i);
      const std::vector<double> vs = divisions((i + 1) % count_);
      for (std::size_t k = 0; k + 1 < us.size(); ++k) {
        for (std::size_t l = 0; l + 1 < vs.size(); ++l) {
          // Towards the corner the sides of the fan run the other way.
          add(part_of(quad, {us[k], us[k + 1]}, {vs[l], vs[l + 1]}), level);
        }
      }
    }
  }

  Ring ring_;
  Polygon rim_;  // on which the arris begins
  const BodyDraws& draws_;
  Face face_;
  std::size_t count_;
  std::vector<Side> sides_;
  bool fan_ = false;
  std::vector<BezierPatch> patches_;
};

// Stones whose faces are higher above their bed are seen down their sides, which are steep then; by eye.
constexpr double free_height_mm = 60.0;
// Over so many of its widths a rounded arris of those goes down. By eye: rounder than a quarter of a circle, as feet leave it.
constexpr double free_arris_rise = 1.5;

double slope_of(Angle tilt) { return sine(tilt.radians()) / cosine(tilt.radians()); }

// A stone half as large again as a whole one is tilted in full, larger ones less.
double tilt_room_mm(const Pavement& pavement) {
  const vec2 slope(slope_of(pavement.variation.tilt.value_or(Angle())));
  return 0.75 * glm::dot(slope, pavement.stone_mm);
}

}  // namespace

BodyDraws body_draws(const Pavement& pavement, std::uint64_t seed, Id stone) {
  const auto draw = [&](Stream stream, std::uint32_t index) { return uniform(seed, {stream, stone, index}); };
  const auto around_zero = [&](Stream stream, std::uint32_t index) { return 2.0 * draw(stream, index) - 1.0; };
  const StoneBody& body = pavement.body;
  BodyDraws draws;
  draws.arris = body.arris;
  draws.arris_mm = body.arris_mm * (1.0 + 0.25 * around_zero(Stream::stone_arris, 0));
  const double height =
      pavement.surface.height_mm * (1.0 + pavement.surface.height_spread * around_zero(Stream::stone_height, 0));
  draws.rise_mm = hidden_depth_mm(pavement) + height;
  const bool stands_free = pavement.surface.height_mm > free_height_mm;
  if (stands_free) draws.flank_mm = std::max(0.0, draws.rise_mm - free_arris_rise * draws.arris_mm);
  draws.crown_mm = body.crown_mm * (1.0 + 0.3 * around_zero(Stream::stone_arris, 1));
  // Each within the unevenness over the root of two, so that both together are.
  draws.warp_mm =
      std::sqrt(0.5) * body.uneven_mm * vec2{around_zero(Stream::stone_arris, 2), around_zero(Stream::stone_arris, 3)};
  draws.slope = slope_of(pavement.variation.tilt.value_or(Angle())) *
                vec2{around_zero(Stream::stone_tilt, 0), around_zero(Stream::stone_tilt, 1)};
  draws.tilt_room_mm = tilt_room_mm(pavement);
  draws.chips_per_m = body.chips_per_m;
  for (std::uint32_t i = 0; i < draws.chips.size(); ++i) {
    draws.chips[i] = {draw(Stream::stone_chip, 3 * i), draw(Stream::stone_chip, 3 * i + 1),
                      draw(Stream::stone_chip, 3 * i + 2)};
  }
  return draws;
}

std::vector<BezierPatch> body_patches(Polygon outline, const BodyDraws& draws, const IsSawn& is_sawn) {
  BodyBuilder builder(ring_of(std::move(outline), draws, is_sawn), draws);
  return draws.arris == Arris::rounded ? builder.rounded() : builder.chamfered();
}

double hidden_depth_mm(const Pavement& pavement) {
  const double corners = (farthest2 - 1.0) * 1.3 * pavement.body.crown_mm;
  return 1.0 + std::max(1.3 * pavement.body.crown_mm, corners) + farthest2 * pavement.body.uneven_mm + tilt_room_mm(pavement);
}

double highest_face_mm(const Pavement& pavement) {
  const paving::StoneSurface& surface = pavement.surface;
  return 2.0 * hidden_depth_mm(pavement) - 1.0 + surface.height_mm * (1.0 + surface.height_spread);
}

}  // namespace shatterpave::paving
