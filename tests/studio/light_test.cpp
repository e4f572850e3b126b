#include "studio/light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "studio/plain_sky.h"

namespace shatterpave::studio {
namespace {

void expect_near(vec3 a, vec3 b) { EXPECT_LT(glm::length(a - b), 1e-14) << a.x << " " << a.y << " " << a.z; }

vec3 to_sun(double azimuth, double elevation) {
  return direction_to({Angle::degrees(azimuth), Angle::degrees(elevation), 1.0});
}

TEST(Sun, StandsWhereACompassSays) {
  expect_near(to_sun(0.0, 0.0), {0.0, 1.0, 0.0});
  expect_near(to_sun(90.0, 0.0), {1.0, 0.0, 0.0});
  expect_near(to_sun(180.0, 0.0), {0.0, -1.0, 0.0});
  expect_near(to_sun(270.0, 0.0), {-1.0, 0.0, 0.0});
  expect_near(to_sun(77.0, 90.0), {0.0, 0.0, 1.0});
  EXPECT_NEAR(to_sun(220.0, 30.0).z, 0.5, 1e-15);
}

TEST(LatLong, MiddleIsNorthRightIsEastAndTopIsOverhead) {
  expect_near(direction_of({0.5, 0.5}, Angle()), {0.0, 1.0, 0.0});
  expect_near(direction_of({0.75, 0.5}, Angle()), {1.0, 0.0, 0.0});
  expect_near(direction_of({0.0, 0.5}, Angle()), {0.0, -1.0, 0.0});
  expect_near(direction_of({0.3, 0.0}, Angle()), {0.0, 0.0, 1.0});
}

TEST(LatLong, IsTurnedCounterClockwiseFromAbove) {
  expect_near(direction_of({0.5, 0.5}, Angle::degrees(90.0)), {-1.0, 0.0, 0.0});
  expect_near(direction_of({0.75, 0.5}, Angle::degrees(90.0)), {0.0, 1.0, 0.0});
}

TEST(LatLong, PlaceAndDirectionAreInverse) {
  for (const double turn : {0.0, 33.0, -250.0}) {
    for (double u = 0.01; u < 1.0; u += 0.09) {
      for (double v = 0.02; v < 1.0; v += 0.12) {
        const vec2 back = place_of(direction_of({u, v}, Angle::degrees(turn)), Angle::degrees(turn));
        EXPECT_NEAR(back.x, u, 1e-12);
        EXPECT_NEAR(back.y, v, 1e-12);
      }
    }
  }
}

TEST(Light, ExposureIsInStops) {
  Light light;
  EXPECT_EQ(exposure_factor(light), 1.0);
  light.exposure_ev = -3.0;
  EXPECT_NEAR(exposure_factor(light), 0.125, 1e-16);
}

// On level ground about what a sky of radiance 1 throws, within a sixth; the twin is a sky without its haze.
TEST(PlainSky, LightsGroundAsOneOfRadianceOne) {
  double sum = 0.0;
  constexpr int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    const double sine = (i + 0.5) / steps;
    sum += plain_sky({std::sqrt(1.0 - sine * sine), 0.0, sine}).y * 2.0 * sine / steps;
  }
  EXPECT_NEAR(sum, 1.0, 1.0 / 6.0);
  EXPECT_LT(plain_sky({0.0, 1.0, -0.5}).y, 0.3);
}

TEST(PlainSky, IsAPictureTwiceAsWideAsHigh) {
  const std::string picture = plain_sky_hdr();
  EXPECT_EQ(picture.find("#?RADIANCE\n"), 0U);
  EXPECT_NE(picture.find("-Y 128 +X 256\n"), std::string::npos);
}

}  // namespace
}  // namespace shatterpave::studio
