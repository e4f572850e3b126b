#include "core/angle.h"

#include <gtest/gtest.h>

namespace shatterpave {
namespace {

TEST(Angle, ConvertsBetweenDegreesAndRadians) {
  EXPECT_DOUBLE_EQ(Angle::degrees(180.0).radians(), pi);
  EXPECT_DOUBLE_EQ(Angle::radians(pi / 3.0).degrees(), 60.0);
}

TEST(Angle, OfAVectorRunsCounterClockwiseFromX) {
  EXPECT_DOUBLE_EQ(Angle::of({2.0, 0.0}).degrees(), 0.0);
  EXPECT_DOUBLE_EQ(Angle::of({0.0, 3.0}).degrees(), 90.0);
  EXPECT_DOUBLE_EQ(Angle::of({-1.0, 0.0}).degrees(), 180.0);
  EXPECT_DOUBLE_EQ(Angle::of({1.0, -1.0}).degrees(), -45.0);
  EXPECT_EQ(Angle::of({0.0, 0.0}).degrees(), 0.0);
}

TEST(Angle, WrapsIntoOneTurnThatEndsAt180) {
  const auto wrapped = [](double degrees) { return Angle::degrees(degrees).wrapped().degrees(); };
  EXPECT_NEAR(wrapped(190.0), -170.0, 1e-12);
  EXPECT_NEAR(wrapped(-190.0), 170.0, 1e-12);
  EXPECT_NEAR(wrapped(725.0), 5.0, 1e-12);
  EXPECT_EQ(wrapped(30.0), Angle::degrees(30.0).degrees());
  EXPECT_EQ(wrapped(180.0), 180.0);
  EXPECT_EQ(wrapped(-180.0), 180.0);
}

TEST(Angle, DirectionAndRotationAgree) {
  for (int degrees = -360; degrees <= 360; degrees += 7) {
    const Angle angle = Angle::degrees(degrees);
    const vec2 turned = rotated({2.0, 0.0}, angle);
    EXPECT_NEAR(turned.x, 2.0 * angle.direction().x, 1e-15);
    EXPECT_NEAR(turned.y, 2.0 * angle.direction().y, 1e-15);
    EXPECT_NEAR(Angle::of(angle.direction()).degrees(), angle.wrapped().degrees(), 1e-12);
  }
  const vec2 up = rotated({3.0, 4.0}, Angle::degrees(90.0));
  EXPECT_NEAR(up.x, left_of({3.0, 4.0}).x, 1e-15);
  EXPECT_NEAR(up.y, left_of({3.0, 4.0}).y, 1e-15);
}

TEST(Angle, OrdersAndAdds) {
  EXPECT_LT(Angle::degrees(10.0), Angle::degrees(20.0));
  EXPECT_EQ(Angle::degrees(10.0) + Angle::degrees(20.0) - Angle::degrees(30.0), Angle());
  EXPECT_EQ(2.0 * Angle::degrees(15.0), Angle::degrees(15.0) * 2.0);
  EXPECT_EQ(-Angle::degrees(15.0), Angle() - Angle::degrees(15.0));
}

}  // namespace
}  // namespace shatterpave
