#include "glass/random_panes.h"

#include <algorithm>
#include <cmath>

#include "core/functions.h"
#include "core/random.h"
#include "geometry/lattice.h"
#include "geometry/simple.h"
#include "glass/breaking.h"
#include "glass/growth/steering.h"

namespace shatterpave::glass {

namespace {

using geometry::Polygon;

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * uniform(seed_, {Stream::turn, Id("random pane"), next_++});
  }
  // Evenly over orders of magnitude.
  double scale(double low, double high) { return low * power(high / low, between(0.0, 1.0)); }
  int count(int low, int high) { return static_cast<int>(between(low, high + 1.0)); }
  bool chance(double share) { return between(0.0, 1.0) < share; }

 private:
  std::uint64_t seed_;
  std::uint32_t next_ = 0;
};

// A star about the origin, its corners at random distances: mostly concave.
Polygon star(Draws& draws) {
  const int corners = draws.count(3, 12);
  const double least = draws.between(0.02, 1.0);
  Polygon outline;
  for (int i = 0; i < corners; ++i) {
    const Angle direction = Angle::radians(2.0 * pi * (i + draws.between(0.0, 0.8)) / corners);
    outline.push_back(draws.between(least, 1.0) * direction.direction());
  }
  return outline;
}

// Like a comb: narrow teeth with nearly parallel sides.
Polygon comb(Draws& draws) {
  const int teeth = draws.count(1, 5);
  Polygon outline = {{0.0, 0.0}, {1.0, 0.0}};
  for (int i = teeth; i > 0; --i) {
    const double right = static_cast<double>(i) / teeth;
    const double gap = draws.between(0.01, 0.6) / teeth;
    outline.emplace_back(right, draws.between(0.5, 1.0));
    outline.emplace_back(right - gap, draws.between(0.5, 1.0));
    if (i > 1) outline.emplace_back(right - gap, draws.between(0.05, 0.4));
    if (i > 1) outline.emplace_back(right - 1.0 / teeth, draws.between(0.05, 0.4));
  }
  return outline;
}

Polygon unit_outline(Draws& draws) {
  switch (draws.count(0, 3)) {
    case 0:
      return {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    case 1:
      return comb(draws);
    default:
      return star(draws);
  }
}

// Vertices within the edges: in line with them, or off by what the lattice rounds.
Polygon with_collinear_vertices(const Polygon& outline, Draws& draws) {
  Polygon result;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    result.push_back(outline[i]);
    if (draws.chance(0.5)) continue;
    result.push_back(glm::mix(outline[i], outline[(i + 1) % outline.size()], draws.between(0.001, 0.999)));
  }
  return result;
}

Polygon outline_on_lattice(Draws& draws) {
  for (;;) {
    Polygon outline = unit_outline(draws);
    if (draws.chance(0.3)) outline = with_collinear_vertices(outline, draws);
    const double size_mm = draws.chance(0.5) ? 300.0 : draws.scale(1.0, 10000.0);
    const double squeeze = draws.chance(0.3) ? draws.scale(0.003, 1.0) : 1.0;
    const Angle turned = draws.chance(0.5) ? Angle::radians(draws.between(0.0, 2.0 * pi)) : Angle{};
    const double room_mm = geometry::largest_coordinate_mm - 2.0 * size_mm;
    const vec2 away = draws.chance(0.4) ? room_mm * vec2{draws.between(-1.0, 1.0), draws.between(-1.0, 1.0)} : vec2{0.0, 0.0};
    for (vec2& vertex : outline) {
      const vec2 v{size_mm * vertex.x, size_mm * squeeze * vertex.y};
      vertex = geometry::on_lattice(away + rotated(v, turned));
    }
    outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
    if (outline.size() < 3 || outline.front() == outline.back()) continue;
    if (!geometry::region_fault(outline, {})) return geometry::oriented_region(std::move(outline), {}).outline;
  }
}

vec2 some_um(Draws& draws) { return {draws.between(-0.004, 0.004), draws.between(-0.004, 0.004)}; }

vec2 place(const Pane& pane, std::uint64_t seed, Draws& draws) {
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  const auto last = static_cast<int>(pane.outline_mm.size()) - 1;
  const auto corner = [&](int i) { return pane.outline_mm[static_cast<std::size_t>(i) % pane.outline_mm.size()]; };
  const int kind = draws.count(0, 5);
  const int from = draws.count(0, last);
  if (kind == 0) return corner(from) + some_um(draws);
  if (kind == 1) return glm::mix(corner(from), corner(from + 1), draws.between(0.0, 1.0)) + some_um(draws);
  if (kind <= 3 && !pane.impacts.empty()) {
    const CrackNetwork network = broken(pane, seed);
    if (network.cracks.empty()) return pane.impacts.front().at_mm;
    const Crack& crack = network.cracks[static_cast<std::size_t>(draws.count(0, static_cast<int>(network.cracks.size()) - 1))];
    const int i = draws.count(1, static_cast<int>(crack.points_mm.size()) - 1);
    const vec2 a = crack.points_mm[static_cast<std::size_t>(i) - 1];
    const vec2 b = crack.points_mm[static_cast<std::size_t>(i)];
    return draws.chance(0.5) ? b : glm::mix(a, b, draws.between(0.0, 1.0)) + some_um(draws);
  }
  return {draws.between(box.low.x, box.high.x), draws.between(box.low.y, box.high.y)};
}

Growth random_growth(double diagonal_mm, Draws& draws) {
  Growth growth;
  if (draws.chance(0.3)) return growth;
  growth.spread = draws.chance(0.5) ? Spread::normal : Spread::uniform;
  growth.spread_limit = draws.between(0.0, 0.95);
  growth.spread_deviation = draws.between(0.0, 3.0);
  growth.radial_speed = draws.scale(0.1, 1000.0);
  growth.large_speed = draws.scale(0.1, 1000.0);
  growth.circular_speed = draws.scale(0.1, 1000.0);
  growth.step_length = draws.scale(0.1, 100.0);
  growth.sector_angle = Angle::degrees(draws.between(1.0, 180.0));
  growth.sector_radius = draws.scale(1.0, 200.0);
  growth.turn_limit = Angle::degrees(draws.between(0.0, 90.0));
  growth.weight_time = draws.scale(0.01, 1000.0);
  growth.turn_length = draws.scale(0.1, 1000.0);
  growth.tip_gain = draws.chance(0.5) ? 40.0 : draws.scale(1.0, 1e6);
  growth.crack_gain = draws.chance(0.5) ? 60.0 : draws.scale(1.0, 1e6);
  growth.sibling_gain = draws.chance(0.5) ? 0.0 : draws.scale(1.0, 1e6);
  growth.edge_gain = draws.chance(0.5) ? 500.0 : draws.scale(1.0, 1e6);
  growth.wander = Angle::degrees(draws.between(0.0, 90.0));
  growth.radial_pull = draws.scale(0.01, 1000.0);
  growth.ring_pull = draws.scale(0.01, 1000.0);
  growth.ring_onset = draws.between(0.0, 2.0);
  growth.circular_threshold = draws.between(0.0, 40.0);
  growth.ring_radius_slope_mm = 0.0;
  growth.ring_radius_offset_mm = draws.scale(0.001, 0.4 * diagonal_mm);
  return growth;
}

// No pane is to need more steps than this from side to side.
void hasten(Growth& growth, double diagonal_mm) {
  constexpr double most_steps = 200.0;
  growth.step_length = std::max(growth.step_length, diagonal_mm / (most_steps * px_mm));
}

}  // namespace

Pane random_pane(std::uint64_t seed, const Oddness& oddness) {
  Draws draws(seed);
  Pane pane;
  pane.name = "odd";
  pane.outline_mm = outline_on_lattice(draws);
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  const double diagonal_mm = glm::length(box.high - box.low);
  pane.growth = random_growth(diagonal_mm, draws);
  hasten(pane.growth, diagonal_mm);
  const int impacts = draws.count(1, oddness.most_impacts);
  while (static_cast<int>(pane.impacts.size()) < impacts) {
    Impact impact;
    impact.at_mm = geometry::on_lattice(place(pane, seed, draws));
    if (!geometry::contains_strictly(pane.outline_mm, impact.at_mm)) continue;
    impact.radial_count = draws.count(1, oddness.most_radials);
    if (draws.chance(0.3)) impact.large_count = draws.count(0, *impact.radial_count);
    impact.circular_count = draws.count(0, 8);
    pane.impacts.push_back(impact);
  }
  return pane;
}

}  // namespace shatterpave::glass
