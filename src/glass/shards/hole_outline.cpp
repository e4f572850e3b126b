#include "glass/shards/hole_outline.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/functions.h"
#include "core/random.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "glass/shards/hole_border.h"

namespace shatterpave::glass {

namespace {

using geometry::Polygon;
using geometry::Region;

// Of the root of the pane's area, for the ball and the speed of the paper: hole of a third of the pane's width. By eye.
constexpr double usual_share = 0.2;
constexpr double energy_power = 0.25;

constexpr int flank_pieces = 7;
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

// A tooth on the edge about `foot`, `width` wide, that points along `in`: its flanks are hollow arcs.
Polygon tooth(vec2 foot, vec2 along, vec2 in, double width, double height, double lean) {
  const vec2 low = tooth_overlap_mm * in;
  const vec2 a = foot - 0.5 * width * along - low;
  const vec2 b = foot + 0.5 * width * along - low;
  const vec2 tip = foot + lean * width * along + height * in;
  const auto flank = [&](vec2 from, vec2 to, Polygon& polygon) {
    const vec2 hollow = glm::mix(0.5 * (from + to), foot, tooth_hollow);
    for (int i = 0; i < flank_pieces; ++i) {
      const double t = static_cast<double>(i) / flank_pieces;
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
    outlines.push_back(hole_border(network, impact.at_mm, radius, seed, id));
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
