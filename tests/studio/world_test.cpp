#include "studio/world.h"

#include <gtest/gtest.h>

namespace shatterpave::studio {
namespace {

TEST(World, APaneStandsUprightAndItsHitSideLooksToTheViewer) {
  EXPECT_EQ(world_of_upright({3.0, 5.0, 0.0}), (vec3{3.0, 0.0, 5.0}));
  EXPECT_EQ(world_of_upright({0.0, 0.0, 1.0}), (vec3{0.0, -1.0, 0.0}));
  EXPECT_EQ(upright_of_world(world_of_upright({3.0, 5.0, 7.0})), (vec3{3.0, 5.0, 7.0}));
}

TEST(World, AThingIsTurnedAboutItsOriginAndThenPutInItsPlace) {
  const Placement placement{{100.0, 200.0, 300.0}, Angle::degrees(90.0)};
  const vec3 at = placed({10.0, 0.0, 5.0}, placement);
  EXPECT_NEAR(at.x, 100.0, 1e-12);
  EXPECT_NEAR(at.y, 210.0, 1e-12);
  EXPECT_EQ(at.z, 305.0);
}

TEST(World, WithoutItsPlaceAThingIsWhereItWas) {
  const Placement placement{{-40.0, 17.0, 3.0}, Angle::degrees(-123.0)};
  const vec3 p{1.0, -2.0, 30.0};
  EXPECT_LT(glm::length(without(placed(p, placement), placement) - p), 1e-12);
}

}  // namespace
}  // namespace shatterpave::studio
