#include "export/shapes/quaternion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle.h"

namespace shatterpave::exporting::shapes {
namespace {

// By Rodrigues' formula.
vec3 turned_about(vec3 axis, Angle angle, vec3 v) {
  const vec2 part = angle.direction();
  return part.x * v + part.y * glm::cross(axis, v) + (1.0 - part.x) * glm::dot(axis, v) * axis;
}

Placing turn_about(vec3 axis, Angle angle) {
  const vec3 x = turned_about(axis, angle, {1, 0, 0});
  const vec3 y = turned_about(axis, angle, {0, 1, 0});
  const vec3 z = turned_about(axis, angle, {0, 0, 1});
  return {{vec3{x.x, y.x, z.x}, vec3{x.y, y.y, z.y}, vec3{x.z, y.z, z.z}}, {0, 0, 0}};
}

// About axes and by angles that make each of the four the largest.
TEST(Quaternion, TurnsAsTheTurnDoes) {
  for (const vec3 axis :
       {vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}, vec3{3, 1, -1}, vec3{-1, 3, 2}, vec3{1, -2, 4}, vec3{-1, -1, -1}}) {
    for (const double degrees : {0.0, 20.0, 90.0, 119.0, 150.0, 180.0, -170.0, -45.0}) {
      const Placing placing = turn_about(glm::normalize(axis), Angle::degrees(degrees));
      const auto [x, y, z, w] = quaternion(placing);
      EXPECT_NEAR(x * x + y * y + z * z + w * w, 1.0, 1e-12);
      const vec3 q{x, y, z};
      for (const vec3 v : {vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}}) {
        const vec3 by_quaternion = v + 2.0 * w * glm::cross(q, v) + 2.0 * glm::cross(q, glm::cross(q, v));
        EXPECT_LT(glm::length(by_quaternion - placing.turned(v)), 1e-12) << degrees;
      }
    }
  }
}

}  // namespace
}  // namespace shatterpave::exporting::shapes
