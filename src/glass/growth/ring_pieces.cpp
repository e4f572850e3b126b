// Ring by ring, the radials that cross its circle divide it into sectors. A sector that is not left out gets a chord from one
// of its two radials to the other: two arms from a starting point near its middle, whose ends on the radials are exact by what
// CrackMap promises. Each piece lies off its ring by an offset of its own; at about half of the radials it meets the next one
// half-way between the two, at the others they are staggered.
#include "glass/growth/ring_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/angle.h"
#include "core/functions.h"
#include "geometry/polygon.h"
#include "glass/growth/radial_course.h"
#include "glass/growth/tip.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;

// A sector wider than this has no neighbour to reach; a chord shorter than this would be a speck.
constexpr double widest_sector = 5.0 / 6.0 * pi;
constexpr double least_chord_mm = 0.4;

// Straight pieces across half-sectors wider than this would cut far into the ring, so they bow. By eye.
constexpr double widest_straight = 0.15 * pi;

// A piece ends in a vertex of the radial that is no farther than this share of the ring's radius from where it should: so at
// the kink, and where the piece on the other side ends.
constexpr double snap_share = 0.02;

// An arm bends in so many steps; and so far it goes on, in chords, where rounding has it miss the radial.
constexpr int arm_steps = 3;
constexpr double ring_overrun = 0.05;

// Bows below this share of the chord are no bows.
constexpr double least_bow = 0.004;

// Strips that are cut off bend like beams and snap where they are longer than this, in widths, at the most by 1.4. By eye.
constexpr double usual_elongation = 2.1;
// A rung leans by up to this share of its length; shorter ones than that would be specks. By eye.
constexpr double greatest_rung_lean = 0.25;
constexpr double narrowest_rung_mm = 2.2;
// Strips much narrower than their neighbours hold on to these and do not snap. By eye.
constexpr double narrowest_share = 0.6;
// None is nearer to the impact, nor within this share of the first ring. By eye.
constexpr double least_rung_start_mm = 3.0;
constexpr double rung_start = 0.25;

struct RadialWall {
  double direction = 0.0;  // radians, of where the radial crosses the ring
  std::size_t radial = 0;
};

struct RingSector {
  double from = 0.0;
  double width = 0.0;
  std::size_t before = 0;  // numbers of radials: the one before its first, its first, its last
  std::size_t first = 0;
  std::size_t last = 0;
};

// Where the crack first comes to be `radius` away from the centre.
std::optional<vec2> crossing(const std::vector<vec2>& points, vec2 centre, double radius) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double before = glm::length(points[i - 1] - centre);
    const double after = glm::length(points[i] - centre);
    if (before >= radius || after < radius) continue;
    return glm::mix(points[i - 1], points[i], (radius - before) / (after - before));
  }
  return std::nullopt;
}

std::vector<RingSector> sectors(const std::vector<std::vector<vec2>>& radials, vec2 centre, double radius) {
  std::vector<RadialWall> walls;
  for (std::size_t i = 0; i < radials.size(); ++i) {
    if (const auto at = crossing(radials[i], centre, radius)) walls.push_back({Angle::of(*at - centre).radians(), i});
  }
  std::ranges::sort(walls, [](const RadialWall& a, const RadialWall& b) {
    return a.direction != b.direction ? a.direction < b.direction : a.radial < b.radial;
  });
  std::vector<RingSector> result;
  const std::size_t n = walls.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    const double to = walls[last ? 0 : i + 1].direction + (last ? 2.0 * pi : 0.0);
    const double width = to - walls[i].direction;
    if (width > widest_sector || width * radius < least_chord_mm) continue;
    result.push_back({walls[i].direction, width, walls[(i + n - 1) % n].radial, walls[i].radial, walls[(i + 1) % n].radial});
  }
  return result;
}

class Laying {
 public:
  Laying(const Pane& pane, const RingCentre& centre, std::span<const int> radials, std::uint64_t seed, CrackMap& map)
      : pane_(pane), centre_(centre), radials_(radials), seed_(seed), speed_mm_us_(ring_speed_mm_us(pane.growth)), map_(map) {}

  // A piece in the sector, unless chance or what stands there forbids it.
  void lay(const RingSector& sector, int ring, double radius) {
    const Id piece = centre_.id.child("ring piece").child(static_cast<std::uint64_t>(ring)).child(sector.first);
    const auto draw = [&](std::uint32_t number) { return uniform(seed_, {Stream::ring_piece, piece, number}); };
    if (draw(0) < pane_.rings.interruption) return;
    const auto from = end_on(sector.first, radius * (1.0 + end_offset(sector, ring, sector.first)), radius);
    const auto to = end_on(sector.last, radius * (1.0 + end_offset(sector, ring, sector.last)), radius);
    if (!from || !to || *from == *to) return;
    const double bow = std::max(pane_.rings.bow * 2.0 * draw(1), 1.0 - widest_straight / (0.5 * sector.width));
    lay_chord(*from, *to, gone_by_us(sector, *from, *to), std::min(bow, 1.0) * sagitta(sector.width, radius),
              0.35 + 0.3 * draw(4));
  }

  // Pieces across the sector between two radii, where it is much longer than wide.
  //   usual_width  of the sectors about there
  void lay_rungs(const RingSector& sector, double usual_width, int ring, double from, double to) {
    if (sector.width < narrowest_share * usual_width) return;
    const Id strip = centre_.id.child("rung").child(static_cast<std::uint64_t>(ring)).child(sector.first);
    const auto draw = [&](std::uint32_t number) { return uniform(seed_, {Stream::rung, strip, number}); };
    const double step = usual_elongation * sector.width;
    double at = from;
    for (std::uint32_t k = 0;; ++k) {
      at *= 1.0 + step * (0.6 + 0.8 * draw(4 * k));
      if (at * (1.0 + 0.4 * step) > to) return;
      if (at * sector.width < narrowest_rung_mm) continue;
      const double lean = greatest_rung_lean * at * sector.width;
      const auto a = end_on(sector.first, at + lean * (2.0 * draw(4 * k + 1) - 1.0), at);
      const auto b = end_on(sector.last, at + lean * (2.0 * draw(4 * k + 2) - 1.0), at);
      if (a && b && *a != *b) lay_rung(*a, *b, gone_by_us(sector, *a, *b));
    }
  }

  const std::vector<int>& arms() const { return arms_; }

 private:
  // Of the circle over its chord.
  static double sagitta(double width, double radius) { return radius * (1.0 - cosine(0.5 * width)); }

  double end_offset(const RingSector& sector, int ring, std::size_t radial) const {
    const auto first = static_cast<int>(sector.first);
    const auto at = static_cast<int>(radial);
    if (is_staggered(seed_, centre_.id, ring, at)) return piece_offset(pane_.rings, seed_, centre_.id, ring, first);
    const auto before = static_cast<int>(radial == sector.first ? sector.before : sector.first);
    return joint_offset(pane_.rings, seed_, centre_.id, ring, at, before);
  }

  // Where a piece is to end on the radial: in a vertex where one is near. A radial that ends short of `radius` is met on its
  // ring, which it crosses.
  std::optional<LatticePoint> end_on(std::size_t radial, double radius, double ring_radius) const {
    std::vector<vec2> line;
    for (const LatticePoint p : map_.points(radials_[radial])) line.push_back(geometry::to_mm(p));
    auto at = crossing(line, centre_.at_mm, radius);
    if (!at) at = crossing(line, centre_.at_mm, ring_radius);
    if (!at) return std::nullopt;
    vec2 nearest = line[1];
    for (std::size_t i = 2; i < line.size(); ++i) {
      if (glm::length(line[i] - *at) < glm::length(nearest - *at)) nearest = line[i];
    }
    return geometry::to_lattice(glm::length(nearest - *at) < snap_share * ring_radius ? nearest : *at);
  }

  // When both radials have come to where a piece between them is to end.
  double gone_by_us(const RingSector& sector, LatticePoint on_first, LatticePoint on_last) const {
    return std::max(map_.time_us(radials_[sector.first], on_first), map_.time_us(radials_[sector.last], on_last));
  }

  // Two arms from the point that divides the chord at `share`, outwards off it by what the bow has there.
  void lay_chord(LatticePoint from, LatticePoint to, double start_us, double bow_mm, double share) {
    const vec2 a = geometry::to_mm(from);
    const vec2 b = geometry::to_mm(to);
    const vec2 out = -left_of(glm::normalize(b - a));
    const auto on_bow = [&](double t) { return glm::mix(a, b, t) + 4.0 * t * (1.0 - t) * bow_mm * out; };
    const LatticePoint at = geometry::to_lattice(on_bow(share));
    if (!geometry::contains(pane_.outline_mm, geometry::to_mm(at)) || map_.is_taken(at) ||
        map_.is_barred(geometry::to_lattice(centre_.at_mm), at, centre_.impact)) {
      return;
    }
    const CrackMap::Hub hub = map_.add_hub(at);
    const int steps = bow_mm > least_bow * glm::length(b - a) ? arm_steps : 1;
    for (const auto& [goal, end] : {std::pair(0.0, from), std::pair(1.0, to)}) {
      const int crack = map_.start(hub, CrackKind::circular, centre_.impact, CrackEnd::At::ring, start_us);
      arms_.push_back(crack);
      bool met = false;
      for (int k = 1; k < steps && !met; ++k) {
        met = map_.run(crack, geometry::to_lattice(on_bow(share + (goal - share) * k / steps)), speed_mm_us_).has_value();
      }
      if (!met) met = map_.run(crack, end, speed_mm_us_).has_value();
      if (!met) run_on(crack, glm::length(b - a));
    }
  }

  // Straight across, from one radial to the other.
  void lay_rung(LatticePoint from, LatticePoint to, double start_us) {
    const vec2 a = geometry::to_mm(from);
    const vec2 b = geometry::to_mm(to);
    const LatticePoint at = geometry::to_lattice(0.5 * (a + b));
    if (map_.is_taken(at) || !geometry::contains(pane_.outline_mm, geometry::to_mm(at)) ||
        map_.is_barred(geometry::to_lattice(centre_.at_mm), at, centre_.impact)) {
      return;
    }
    const CrackMap::Hub hub = map_.add_hub(at);
    for (const LatticePoint end : {from, to}) {
      const int crack = map_.start(hub, CrackKind::rung, centre_.impact, CrackEnd::At::ring, start_us);
      if (!map_.run(crack, end, speed_mm_us_)) run_on(crack, glm::length(b - a));
    }
  }

  // On to the radial that rounding had the arm miss.
  void run_on(int crack, double chord_mm) {
    const std::vector<LatticePoint> points = map_.points(crack);
    const vec2 tip = geometry::to_mm(points.back());
    const vec2 heading = glm::normalize(tip - geometry::to_mm(points[points.size() - 2]));
    if (!map_.run(crack, geometry::to_lattice(tip + ring_overrun * chord_mm * heading), speed_mm_us_))
      map_.stop(crack, CrackEnd::At::open);
  }

  const Pane& pane_;
  const RingCentre& centre_;
  std::span<const int> radials_;
  std::uint64_t seed_;
  double speed_mm_us_;
  CrackMap& map_;
  std::vector<int> arms_;
};

}  // namespace

std::vector<int> lay_ring_pieces(const Pane& pane, const RingCentre& centre, std::span<const int> radials, std::uint64_t seed,
                                 CrackMap& map) {
  std::vector<std::vector<vec2>> lines;
  double farthest = 0.0;
  for (const int radial : radials) {
    std::vector<vec2>& line = lines.emplace_back();
    for (const LatticePoint p : map.points(radial)) {
      line.push_back(geometry::to_mm(p));
      farthest = std::max(farthest, glm::length(line.back() - centre.at_mm));
    }
  }
  Laying laying(pane, centre, radials, seed, map);
  const std::vector<double> rings = ring_radii(pane, farthest);
  for (std::size_t k = 0; k < rings.size(); ++k) {
    for (const RingSector& sector : sectors(lines, centre.at_mm, rings[k])) laying.lay(sector, static_cast<int>(k), rings[k]);
  }
  // Between rings, and from near the impact to the first and from the last to the edge, in steps about as wide as those.
  constexpr double stride = 1.5;
  std::vector<double> bounds{rings.empty() ? least_rung_start_mm : std::max(least_rung_start_mm, rung_start * rings.front())};
  const auto go_to = [&](double end) {
    while (bounds.back() * stride * stride < end) bounds.push_back(bounds.back() * stride);
    bounds.push_back(end);
  };
  for (const double ring : rings) go_to(ring);
  go_to(farthest);
  for (std::size_t k = 0; k + 1 < bounds.size(); ++k) {
    const double middle = std::sqrt(bounds[k] * bounds[k + 1]);
    const std::vector<RingSector> across = sectors(lines, centre.at_mm, middle);
    for (const RingSector& sector : across) {
      laying.lay_rungs(sector, 2.0 * pi / static_cast<double>(across.size()), static_cast<int>(k), bounds[k], bounds[k + 1]);
    }
  }
  return laying.arms();
}

}  // namespace shatterpave::glass
