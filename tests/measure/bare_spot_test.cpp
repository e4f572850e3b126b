#include "measure/bare_spot.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/parallel.h"
#include "core/random.h"
#include "geometry/lattice.h"
#include "paving/laying.h"
#include "paving/paved_areas.h"

namespace shatterpave::measure {
namespace {

using paving::Pavement;
using paving::Stone;
using paving::StoneLayout;

geometry::Circle spot_of(const Pavement& pavement, const StoneLayout& layout) {
  return widest_bare_spot(pavement, layout, StoneIndex(layout, 100.0), geometry::RegionIndex(pavement.area));
}

double widest(const Pavement& pavement, const StoneLayout& layout) { return 2.0 * spot_of(pavement, layout).radius; }

Pavement field(double width, double height) {
  return paving::pavement({{{0, 0}, {width, 0}, {width, height}, {0, height}}, {}}, 100, 8, paving::straight(0));
}

Stone block(double x, double y, double width, double height) {
  return {0, paving::StoneKind::whole, {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, {}};
}

// Growth is more than half a joint by a hairline of 0.01 mm, on either side of what is left bare.
constexpr double hairlines = 0.04;

TEST(BareSpot, OfPlainRowsIsWhereAStoneIsMissing) {
  const Pavement paved = field(4320, 3240);  // 40 × 30 stones
  StoneLayout layout = paving::laid_stones(paved, 1);
  ASSERT_EQ(layout.stones.size(), 1200U);
  EXPECT_EQ(widest(paved, layout), 0.0);
  const auto without = [&](std::size_t s) {
    StoneLayout other = layout;
    other.stones.erase(other.stones.begin() + static_cast<std::ptrdiff_t>(s));
    return other;
  };
  const geometry::Circle inside = spot_of(paved, without(610));
  EXPECT_NEAR(2.0 * inside.radius, 108.0 - hairlines, 1e-3);
  EXPECT_LT(glm::length(inside.middle - geometry::centroid(layout.stones[610].outline_mm)), 0.01);
  EXPECT_NEAR(widest(paved, without(0)), 104.0 - 0.5 * hairlines, 1e-3)
      << "in a corner, where half a joint is free on two sides";
}

TEST(BareSpot, IsSeenWholeHoweverWide) {
  const Pavement paved = field(10'800, 10'800);
  StoneLayout layout = paving::laid_stones(paved, 1);
  // All that lies within 4 m of the middle: wider than many tiles.
  std::erase_if(layout.stones, [](const Stone& s) {
    const vec2 d = geometry::centroid(s.outline_mm) - vec2{5400.0, 5400.0};
    return std::max(std::abs(d.x), std::abs(d.y)) < 4000.0;
  });
  EXPECT_NEAR(widest(paved, layout), 74.0 * 108.0 - hairlines, 0.02);
  EXPECT_NEAR(widest(paved, {}), 10'800.0 - 8.0, 1e-3) << "nothing is laid";
}

TEST(BareSpot, IsTheWedgeBesideALeaningSide) {
  const Pavement paved = field(216, 108);
  const StoneLayout layout{
      {block(4, 4, 100, 100), {1, paving::StoneKind::cut, {{112, 4}, {212, 4}, {212, 104}, {152, 104}}, {}}}, {}};
  // Bare: a triangle between the first stone's cell, the border and the slope of 2.5, set off by half a joint.
  const double slope = std::sqrt(40.0 * 40.0 + 100.0 * 100.0);
  const double top = 108.0 + 40.0 - (4.0 * slope / 100.0 - 4.0);  // where the slope, set off, is 4 mm off the border
  const double width = top - 108.0;
  const double height = 100.0 * width / 40.0;
  const double in = width * height / (width + height + std::sqrt(width * width + height * height));
  EXPECT_NEAR(widest(paved, layout), 2.0 * in, 0.05);
}

// Between two rows of a border that meet at a slant, what they leave goes on in a needle along one of them. It was taken for a
// strip, and nothing was laid.
TEST(BareSpot, IsNoneWhereWhatTheBorderLeavesEndsInANeedle) {
  Pavement tip = field(1, 1);
  tip.area = {{{-10631.807, -15570.004}, {-12168.386, -15660.639}, {-11079.655, -15775.789}}, {}};
  tip.stone_mm = {50.2, 50.2};
  tip.joint_mm = 0.0;
  tip.bonding.bond = paving::Bond::herringbone;
  tip.border.course = paving::BorderCourse::stretcher;
  tip.direction = paving::RadialDirection{{-10922.557, -15746.599}};
  EXPECT_LT(widest(tip, paving::laid_stones(tip, 894)), 0.1 * 50.2);
}

// Rectangles at random in squares of 100 mm: grown, with their corners, they are rectangles again, so that the room about a
// place is known.
TEST(BareSpot, IsAsWideAsASearchFinds) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const double joint = 10.0;
    Pavement paved = field(1200, 900);
    paved.joint_mm = joint;
    StoneLayout layout;
    for (int i = 0; i < 12; ++i) {
      for (int j = 0; j < 9; ++j) {
        const auto draw = [&](std::uint32_t n) {
          return std::round(
              20.0 * uniform(seed, {Stream::packing,
                                    Id("block").child(12 * static_cast<std::uint64_t>(j) + static_cast<std::uint64_t>(i)), n}));
        };
        if (draw(9) == 0.0) continue;
        const vec2 low{100.0 * i + 5.0 + draw(0), 100.0 * j + 5.0 + draw(1)};
        const vec2 high{100.0 * i + 95.0 - draw(2), 100.0 * j + 95.0 - draw(3)};
        layout.stones.push_back(block(low.x, low.y, high.x - low.x, high.y - low.y));
      }
    }
    const auto room = [&](vec2 p) {
      double least = std::min({p.x - 5.0, 1195.0 - p.x, p.y - 5.0, 895.0 - p.y});
      for (const Stone& s : layout.stones) {
        const vec2 off = glm::max(s.outline_mm[0] - 5.0 - p, p - s.outline_mm[2] - 5.0);
        const vec2 out = glm::max(off, vec2{0.0, 0.0});
        least = std::min(least, std::max(off.x, off.y) < 0.0 ? 0.0 : glm::length(out));
      }
      return least;
    };
    double found = 0.0;
    for (double x = 5.0; x < 1195.0; x += 2.5) {
      for (double y = 5.0; y < 895.0; y += 2.5) found = std::max(found, room({x, y}));
    }
    const geometry::Circle spot = spot_of(paved, layout);
    EXPECT_GE(spot.radius, found - hairlines) << seed;
    EXPECT_NEAR(room(spot.middle), spot.radius, hairlines) << seed;
  }
}

TEST(BareSpot, IsTheSameWithAnyNumberOfThreads) {
  const Pavement paved = paving::pavement(paving::concave_area(), 100, 8, paving::BoundaryDirection{});
  StoneLayout layout = paving::laid_stones(paved, 7);
  layout.stones.erase(layout.stones.begin() + 100);
  std::vector<double> all;
  for (const int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    all.push_back(widest(paved, layout));
  }
  EXPECT_EQ(all[1], all[0]);
  EXPECT_EQ(all[2], all[0]);
}

}  // namespace
}  // namespace shatterpave::measure
