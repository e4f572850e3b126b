// Ring by ring, the radials that cross its circle divide it into sectors. A sector that is not left out gets a starting point
// near its middle, from where two arms go to both sides: their ends on the radials are exact by what CrackMap promises.
#include "glass/growth/ring_pieces.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "geometry/polygon.h"

namespace shatterpave::glass {

namespace {

using geometry::LatticePoint;

// A sector wider than this has no neighbour to reach; a chord shorter than this would be a speck.
constexpr double widest_sector = 5.0 / 6.0 * pi;
constexpr double least_chord_mm = 0.4;

// Straight pieces across half-sectors wider than this would meet the radials far beyond their ring, so they bow. By eye.
constexpr double widest_straight = 0.15 * pi;

// Steps of an arm to the middle of a radial, and how much farther it goes before it ends open.
constexpr double arm_steps = 3.0;
constexpr double longest_arm = 1.6;

// How far pieces lean against the circle: by eye.
constexpr Angle greatest_lean = Angle::degrees(9.0);

struct Wall {
  double direction = 0.0;  // radians, of where the radial crosses the ring
  std::size_t radial = 0;
};

struct RingSector {
  double from = 0.0;
  double width = 0.0;
  Id piece;
};

// Where the crack first comes to be `radius` away from the centre.
bool crosses(const std::vector<vec2>& points, vec2 centre, double radius, double& direction) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double before = glm::length(points[i - 1] - centre);
    const double after = glm::length(points[i] - centre);
    if (before >= radius || after < radius) continue;
    const vec2 at = glm::mix(points[i - 1], points[i], (radius - before) / (after - before));
    direction = Angle::of(at - centre).radians();
    return true;
  }
  return false;
}

std::vector<RingSector> sectors(const std::vector<std::vector<vec2>>& radials, vec2 centre, double radius, Id ring) {
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < radials.size(); ++i) {
    Wall wall{0.0, i};
    if (crosses(radials[i], centre, radius, wall.direction)) walls.push_back(wall);
  }
  std::ranges::sort(walls, [](const Wall& a, const Wall& b) {
    return a.direction != b.direction ? a.direction < b.direction : a.radial < b.radial;
  });
  std::vector<RingSector> result;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const bool last = i + 1 == walls.size();
    const double to = walls[last ? 0 : i + 1].direction + (last ? 2.0 * pi : 0.0);
    const double width = to - walls[i].direction;
    if (width > widest_sector || width * radius < least_chord_mm) continue;
    result.push_back({walls[i].direction, width, ring.child(static_cast<std::uint64_t>(walls[i].radial))});
  }
  return result;
}

class Laying {
 public:
  Laying(const Pane& pane, const RingCentre& centre, std::uint64_t seed, CrackMap& map)
      : pane_(pane), centre_(centre), seed_(seed), map_(map) {}

  // A piece in the sector, unless chance or what stands there forbids it.
  void lay(const RingSector& sector, double radius) {
    const auto draw = [&](std::uint32_t number) { return uniform(seed_, {Stream::ring_piece, sector.piece, number}); };
    if (draw(0) < pane_.rings.interruption) return;
    const double bow = std::max(pane_.rings.bow * 2.0 * draw(1), 1.0 - widest_straight / (0.5 * sector.width));
    const double bent = std::min(bow, 1.0);
    // So much that a piece lies about its ring in the mean, not beyond.
    const double back = (1.0 - bent) * sector.width * sector.width / 24.0;
    const double off = pane_.rings.spread * (2.0 * draw(2) - 1.0) * (pane_.rings.ratio - 1.0);
    const double r = radius * (1.0 + off - back);
    const vec2 out = Angle::radians(sector.from + sector.width * (0.35 + 0.3 * draw(3))).direction();
    const LatticePoint at = geometry::to_lattice(centre_.at_mm + r * out);
    if (!geometry::contains(pane_.outline_mm, geometry::to_mm(at)) || map_.is_taken(at) ||
        map_.is_barred(geometry::to_lattice(centre_.at_mm), at, centre_.impact)) {
      return;
    }
    const CrackMap::Hub hub = map_.add_hub(at);
    const vec2 along = rotated(left_of(out), (2.0 * draw(4) - 1.0) * greatest_lean);
    grow_arm(hub, at, along, bent / r, sector.width * r);
    grow_arm(hub, at, -along, -bent / r, sector.width * r);
  }

  const std::vector<int>& arms() const { return arms_; }

 private:
  // `turn`: per mm, counter-clockwise.
  void grow_arm(CrackMap::Hub hub, LatticePoint at, vec2 heading, double turn, double chord_mm) {
    const int crack = map_.start(hub, CrackKind::circular, centre_.impact, CrackEnd::At::ring);
    arms_.push_back(crack);
    const double step = 0.5 * chord_mm / arm_steps;
    const Angle bend = Angle::radians(turn * step);
    vec2 place = geometry::to_mm(at);
    for (double gone = 0.0; gone < longest_arm * chord_mm; gone += step) {
      heading = rotated(heading, bend);
      place += step * heading;
      if (map_.extend(crack, geometry::to_lattice(place))) return;
    }
    map_.stop(crack, CrackEnd::At::open);
  }

  const Pane& pane_;
  const RingCentre& centre_;
  std::uint64_t seed_;
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
  Laying laying(pane, centre, seed, map);
  double radius = pane.rings.first_radius_mm;
  for (int k = 0; k < pane.rings.count && radius < farthest; ++k, radius *= pane.rings.ratio) {
    const Id ring = centre.id.child("ring piece").child(static_cast<std::uint64_t>(k));
    for (const RingSector& sector : sectors(lines, centre.at_mm, radius, ring)) laying.lay(sector, radius);
  }
  return laying.arms();
}

}  // namespace shatterpave::glass
