#include "glass/growth/steering.h"

#include <gtest/gtest.h>

#include <array>

#include "core/functions.h"

namespace shatterpave::glass {
namespace {

constexpr vec2 ahead{1.0, 0.0};

TEST(Steering, InertiaIsThatOfEquation19) {
  const Growth growth;
  EXPECT_EQ(inertia(0.0, growth), 1.0);
  EXPECT_NEAR(inertia(10.0, growth), 1.0 / 2.718281828459045, 1e-15);
  EXPECT_LT(inertia(1000.0, growth), 1e-12);
  EXPECT_NEAR(inertia(3.0, growth) * inertia(4.0, growth), inertia(7.0, growth), 1e-15);
}

TEST(Steering, TurnIsTheClampedDifferenceTimesTheWeight) {
  const Growth growth;
  const double w = 0.4;
  EXPECT_NEAR(turn(rotated(ahead, Angle::degrees(20.0)), ahead, w, 10.0, growth).degrees(), 20.0 * w, 1e-12);
  EXPECT_NEAR(turn(rotated(ahead, Angle::degrees(-20.0)), ahead, w, 10.0, growth).degrees(), -20.0 * w, 1e-12);
  EXPECT_NEAR(turn(rotated(ahead, Angle::degrees(80.0)), ahead, w, 10.0, growth).degrees(), 30.0 * w, 1e-12);
  EXPECT_NEAR(turn(rotated(ahead, Angle::degrees(-179.0)), ahead, w, 10.0, growth).degrees(), -30.0 * w, 1e-12);
}

TEST(Steering, TurnedIsRotated) {
  for (int i = -18; i <= 18; ++i) {
    const Angle angle = Angle::degrees(20.0 * i);
    EXPECT_NEAR(glm::length(turned({3.0, -4.0}, angle) - rotated({3.0, -4.0}, angle)), 0.0, 1e-14);
  }
}

TEST(Steering, ShortStepsTurnByTheirShare) {
  const Growth growth;
  const vec2 force = rotated(ahead, Angle::degrees(20.0));
  EXPECT_NEAR(turn(force, ahead, 0.4, 2.5, growth).degrees(), 5.0 * 0.4, 1e-12);
  EXPECT_EQ(turn(force, ahead, 0.4, 25.0, growth), turn(force, ahead, 0.4, 10.0, growth));
}

// The turns of four quarter steps shall spread as that of a whole one: variances add.
TEST(Steering, WanderIsThatOfTheLengthGone) {
  const Growth growth;
  const auto off = [&](double step_px) {
    return turn(wandering_force(ahead, 1.0, step_px, growth), ahead, 1.0, step_px, growth).degrees();
  };
  EXPECT_NEAR(off(10.0), growth.wander.degrees(), 1e-9);
  EXPECT_NEAR(4.0 * off(2.5) * off(2.5), off(10.0) * off(10.0), 1e-9);
}

TEST(Steering, TipsPushAwayWithTheSquareOfTheDistance) {
  const Growth growth;
  const std::array<vec2, 1> near_tip = {vec2{3.0 * px_mm, 4.0 * px_mm}};
  Sight near;
  near.tips_mm = near_tip;
  const vec2 force = force_of(near, growth);
  EXPECT_NEAR(glm::length(force), growth.tip_gain / 25.0, 1e-12);
  EXPECT_NEAR(glm::dot(glm::normalize(force), vec2(-0.6, -0.8)), 1.0, 1e-12);
  const std::array<vec2, 1> far_tip = {2.0 * near_tip[0]};
  Sight far;
  far.tips_mm = far_tip;
  EXPECT_NEAR(glm::length(force_of(far, growth)), 0.25 * glm::length(force), 1e-12);
}

TEST(Steering, CracksAndTheEdgePullAtRightAngles) {
  const Growth growth;
  Sight sight;
  sight.edge = Wall{{0.0, 1.0}, 10.0 * px_mm};
  EXPECT_NEAR(glm::length(force_of(sight, growth) - vec2(0.0, growth.edge_gain / 100.0)), 0.0, 1e-12);
  sight.crack = Wall{{1.0, 0.0}, 5.0 * px_mm};
  EXPECT_NEAR(glm::length(force_of(sight, growth) - vec2(growth.crack_gain / 25.0, growth.edge_gain / 100.0)), 0.0, 1e-12);
}

TEST(Steering, RingCracksGoAlongTheirCircleAndBackToIt) {
  const Ring ring{{10.0, 20.0}, 50.0, true};
  EXPECT_NEAR(glm::length(direction_along(ring, {60.0, 20.0}) - vec2(0.0, 1.0)), 0.0, 1e-12);
  EXPECT_LT(direction_along(ring, {62.0, 20.0}).x, -0.1);
  EXPECT_GT(direction_along(ring, {58.0, 20.0}).x, 0.1);
  const Ring clockwise{{10.0, 20.0}, 50.0, false};
  EXPECT_NEAR(glm::length(direction_along(clockwise, {60.0, 20.0}) - vec2(0.0, -1.0)), 0.0, 1e-12);
  // A quarter of the circle turns by a quarter turn, each its own way.
  EXPECT_NEAR(glm::length(bent_along(ring, {0.0, 1.0}, 25.0 * pi) - vec2(-1.0, 0.0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(bent_along(clockwise, {0.0, -1.0}, 25.0 * pi) - vec2(-1.0, 0.0)), 0.0, 1e-12);
}

}  // namespace
}  // namespace shatterpave::glass
