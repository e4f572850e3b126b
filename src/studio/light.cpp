#include "studio/light.h"

#include <algorithm>
#include <cmath>

namespace shatterpave::studio {

namespace {

// Counter-clockwise from +x of what stands at that azimuth, which is clockwise from +y.
Angle of_azimuth(Angle azimuth) { return Angle::radians(0.5 * pi) - azimuth; }

vec3 direction(Angle from_x, Angle elevation) {
  const vec2 level = from_x.direction();
  const vec2 up = elevation.direction();
  return {up.x * level.x, up.x * level.y, up.y};
}

}  // namespace

vec3 direction_to(const Sun& sun) { return direction(of_azimuth(sun.azimuth), sun.elevation); }

vec3 direction_of(vec2 place, Angle environment_turn) {
  const Angle azimuth = Angle::radians(2.0 * pi * (place.x - 0.5));
  return direction(of_azimuth(azimuth) + environment_turn, Angle::radians(pi * (0.5 - place.y)));
}

vec2 place_of(vec3 direction, Angle environment_turn) {
  const Angle azimuth = of_azimuth(Angle::of({direction.x, direction.y}) - environment_turn);
  const double turns = azimuth.radians() / (2.0 * pi) + 0.5;
  return {turns - std::floor(turns), arccosine(std::clamp(direction.z / glm::length(direction), -1.0, 1.0)) / pi};
}

double exposure_factor(const Light& light) { return power(2.0, light.exposure_ev); }

}  // namespace shatterpave::studio
