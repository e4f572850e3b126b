#include "geometry/needles.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace shatterpave::geometry
