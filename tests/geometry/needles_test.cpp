#include "geometry/needles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/contacts.h"

namespace shatterpave::geometry {
namespace {

const Polygon plain_ground = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};

TEST(Needles, LeaveRegionsWithoutThemAsTheyAre) {
  // Sharp, but no needle; and a tip of the region itself, however sharp.
  for (const Region& region :
       {Region{plain_ground, {{{20, 50}, {60, 50.2}, {60, 50}}}}, Region{{{0, 0}, {100, 0.02}, {0, 0.04}}, {}}}) {
    const Region left = without_needles(region);
    EXPECT_EQ(left.outline, region.outline);
    EXPECT_EQ(left.holes, region.holes);
  }
}

TEST(Needles, AreGivenRoomInHolesAndNotches) {
  const Region hole{plain_ground, {{{20, 50}, {60, 50.02}, {60, 50}}}};
  const Region notch{{{0, 0}, {100, 0}, {100, 49.99}, {50, 50}, {100, 50.01}, {100, 100}, {0, 100}}, {}};
  for (const auto& [region, tip] : {std::pair{hole, vec2{20, 50}}, std::pair{notch, vec2{50, 50}}}) {
    const Region left = without_needles(region);
    EXPECT_TRUE(contains(region, tip));
    EXPECT_FALSE(contains(left, tip));
    EXPECT_NEAR(area(left), area(region), 0.6);  // some 100 mm of sides, by 2 µm on either side
    EXPECT_LT(area(left), area(region));
  }
}

// ---- slivers

constexpr double width_mm = 0.004;

TEST(Slivers, OfRegionsWithoutThemTakeNothing) {
  const Region holed{plain_ground, {{{20, 50}, {60, 70}, {60, 50}}}};
  const Region stretched{{{0, 0}, {1000, 0}, {1000, 0.005}, {0, 0.005}}, {}};  // 1 m long and wider than a sliver
  for (const Region& region : {holed, stretched}) {
    const std::vector<Region> left = without_slivers({region}, width_mm);
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left.front().outline, region.outline);
    EXPECT_EQ(left.front().holes, region.holes);
  }
}

// What rounding leaves between a gap and the edge beside it: 2 µm wide and 40 mm long.
TEST(Slivers, AreCutOffAndWhatIsBesideThemStays) {
  const Region spiked{{{0, 0}, {140, 0}, {100, 0.002}, {100, 100}, {0, 100}}, {}};
  const std::vector<Region> left = without_slivers({spiked}, width_mm);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_NEAR(area(left.front()), 10000.0, 1e-3);
  EXPECT_LT(bounding_box(left.front().outline).high.x, 100.1);
  for (const vec2 corner : {vec2{0, 0}, vec2{100, 100}, vec2{0, 100}}) {
    EXPECT_NE(std::ranges::find(left.front().outline, corner), left.front().outline.end());
  }
  EXPECT_TRUE(without_slivers({Region{{{0, 0}, {1000, 0}, {1000, 0.003}, {0, 0.003}}, {}}}, width_mm).empty());
}

TEST(Slivers, PartARegionAtItsNeck) {
  const Region dumb_bell{
      {{0, 0}, {10, 0}, {10, 5}, {20, 5}, {20, 0}, {30, 0}, {30, 10}, {20, 10}, {20, 5.002}, {10, 5.002}, {10, 10}, {0, 10}},
      {}};
  const std::vector<Region> left = without_slivers({dumb_bell}, width_mm);
  ASSERT_EQ(left.size(), 2U);
  for (const Region& half : left) EXPECT_NEAR(area(half), 100.0, 0.01);
}

// Stars with spikes of some µm, at any angle and far from the origin, as cutting leaves them.
TEST(Slivers, OfSpikedStarsLeaveSimpleOutlinesNearlyAsLarge) {
  std::mt19937_64 random(7);
  const auto between = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  for (int round = 0; round < 2000; ++round) {
    const vec2 middle{between(-1e6, 1e6), between(-1e6, 1e6)};
    const int corners = std::uniform_int_distribution(5, 12)(random);
    Polygon body;
    Polygon spiked;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + between(0.0, 0.6)) / corners;
      const vec2 outwards{std::cos(angle), std::sin(angle)};
      const vec2 at = on_lattice(middle + between(10.0, 20.0) * outwards);
      body.push_back(at);
      spiked.push_back(at);
      const vec2 beside = on_lattice(at + between(0.0005, 0.0015) * vec2{-outwards.y, outwards.x});
      if (beside == at || between(0.0, 1.0) > 0.4) continue;
      spiked.push_back(on_lattice(at + between(0.5, 30.0) * outwards));
      spiked.push_back(beside);
    }
    const std::vector<Region> made = parted({Region{spiked, {}}});
    const std::vector<Region> left = without_slivers(made, width_mm);
    ASSERT_EQ(left.size(), 1U) << round;
    EXPECT_TRUE(contacts(rings_of(left)).empty()) << round;
    EXPECT_NEAR(area(left.front()), area(Region{body, {}}), 0.25) << round;  // 120 mm of sides by 2 µm
    const Box box = bounding_box(left.front().outline);
    EXPECT_LT(std::max({box.high.x - middle.x, middle.x - box.low.x, box.high.y - middle.y, middle.y - box.low.y}), 20.2);
  }
}

}  // namespace
}  // namespace shatterpave::geometry
