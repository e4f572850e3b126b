#include "geometry/inscribed_circle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/functions.h"
#include "core/random.h"
#include "geometry/lattice.h"
#include "geometry/region_index.h"
#include "support/rings.h"

namespace shatterpave::geometry {
namespace {

using support::reversed;

Polygon rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

double radius(const Region& region) { return inscribed_circle(region).radius; }

TEST(InscribedCircle, OfPlainShapesIsExact) {
  EXPECT_NEAR(radius({rectangle(10, 20, 300, 100), {}}), 50.0, 1e-6);
  EXPECT_NEAR(radius({{{0, 0}, {300, 0}, {0, 400}}, {}}), 100.0, 1e-6) << "half of 3 + 4 − 5";
  EXPECT_NEAR(radius({rectangle(0, 0, 1000, 0.5), {}}), 0.25, 1e-6) << "a slit";
  EXPECT_NEAR(radius({rectangle(-1e6, 999'999, 2e6, 1), {}}), 0.5, 1e-6) << "from one end of the world to the other";
  const Circle in_corner = inscribed_circle({rectangle(0, 0, 100, 100), {reversed(rectangle(40, 40, 20, 20))}});
  // As far from two sides as from the hole's corner: c = √2 (40 − c).
  EXPECT_NEAR(in_corner.radius, 40.0 * std::sqrt(2.0) / (1.0 + std::sqrt(2.0)), 1e-3);
  EXPECT_NEAR(std::abs(in_corner.middle.x - 50.0), std::abs(in_corner.middle.y - 50.0), 1e-3);
  EXPECT_EQ(radius({{{0, 0}, {0.001, 0}, {0, 0.001}}, {}}) < 0.001, true);
}

TEST(InscribedCircle, BearsRingsThatTouchAndCross) {
  // Two squares that meet in a corner, as one ring.
  const Polygon pinched{{0, 0}, {50, 0}, {50, 50}, {110, 50}, {110, 110}, {50, 110}, {50, 50}, {0, 50}};
  EXPECT_NEAR(radius({pinched, {}}), 30.0, 1e-6);
  // A hole with a corner on the outline, and one with a side on it.
  // As far from two sides as from a corner of the hole: (30 − r)² + (20 − r)² = r².
  EXPECT_NEAR(radius({rectangle(0, 0, 100, 40), {{{50, 0}, {30, 20}, {70, 20}}}}), 50.0 - std::sqrt(1200.0), 1e-3);
  EXPECT_NEAR(radius({rectangle(0, 0, 100, 40), {reversed(rectangle(40, 0, 20, 40))}}), 20.0, 1e-6);
  // A hole that sticks out by two lattice steps, as rounding may leave it.
  EXPECT_NEAR(radius({rectangle(0, 0, 100, 40), {reversed(rectangle(40, -0.002, 20, 30))}}), 20.0, circle_tolerance_mm);
  // A thin spike out and back.
  EXPECT_NEAR(radius({{{0, 0}, {100, 0}, {200, 0}, {100, 0}, {100, 40}, {0, 40}}, {}}), 20.0, 1e-6);
}

// The best of a grid of places, then of ever finer grids about it.
double radius_by_search(const Region& region) {
  const RegionIndex border(region);
  const auto room = [&](vec2 p) { return border.contains(on_lattice(p)) ? border.nearest(p).distance_mm : 0.0; };
  const auto best_about = [&](vec2 middle, vec2 half, int steps) {
    vec2 best = middle;
    for (int i = -steps; i <= steps; ++i) {
      for (int j = -steps; j <= steps; ++j) {
        const vec2 p = middle + half * vec2{i, j} / static_cast<double>(steps);
        if (room(p) > room(best)) best = p;
      }
    }
    return best;
  };
  vec2 half = 0.5 * (border.box().high - border.box().low);
  vec2 best = best_about(border.box().low + half, half, 60);
  for (half /= 30.0; std::max(half.x, half.y) > 1e-3; half *= 0.25) best = best_about(best, half, 8);
  return room(best);
}

Polygon star(std::uint64_t seed, vec2 middle, double size) {
  const auto draw = [&](std::uint32_t n) { return uniform(seed, {Stream::packing, Id("star"), n}); };
  const int corners = 3 + static_cast<int>(12.0 * draw(0));
  Polygon ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * pi * (i + 0.8 * draw(static_cast<std::uint32_t>(2 * i + 1))) / corners;
    const double length = size * (0.2 + 0.8 * draw(static_cast<std::uint32_t>(2 * i + 2)));
    ring.push_back(on_lattice(middle + length * vec2{cosine(angle), sine(angle)}));
  }
  return ring;
}

TEST(InscribedCircle, IsAsLargeAsASearchFinds) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Region region{star(seed, {1e5, -2e5}, 100.0), {reversed(star(seed + 1000, {1e5 + 3.0, -2e5}, 12.0))}};
    const Circle circle = inscribed_circle(region);
    const RegionIndex border(region);
    EXPECT_TRUE(border.contains(on_lattice(circle.middle)));
    EXPECT_NEAR(border.nearest(circle.middle).distance_mm, circle.radius, 1e-9);
    EXPECT_GE(circle.radius, radius_by_search(region) - circle_tolerance_mm) << seed;
  }
}

}  // namespace
}  // namespace shatterpave::geometry
