// What lights a scene: an environment far away all around, and a sun.
#pragma once

#include <optional>
#include <string>

#include "core/angle.h"
#include "core/vec.h"

namespace shatterpave::studio {

// The sun's disc as seen from the earth.
inline constexpr double sun_diameter_deg = 0.53;

// What a sun of gain 1 throws on a surface that looks at it, where an environment of radiance 1 all around throws pi: three
// times that, as at a noon of some haze (60,000 beside 20,000 lux). Under a clear sky it is five times; by eye, so that stones
// in both keep within the picture without an exposure.
inline constexpr double noon_irradiance = 3.0 * pi;

struct Sun {
  Angle azimuth;                           // where it stands: from +y, clockwise, as a compass says it
  Angle elevation = Angle::degrees(30.0);  // above the horizon, −90 … 90°
  double gain = 1.0;                       // 1: as bright as noon beside an environment of gain 1

  bool operator==(const Sun&) const = default;
};

struct Light {
  std::string environment;        // a name of those installed, or the file that the scene names; empty: a plain sky
  Angle environment_turn;         // about the upright, counter-clockwise from above
  Angle environment_blur;         // it is seen out of focus: diameter of the disc that a point becomes, 0 … 60°
  double environment_gain = 1.0;  // >= 0
  std::optional<Sun> sun;
  double exposure_ev = 0.0;  // the picture is brighter by 2 to this power

  bool operator==(const Light&) const = default;
};

// The unit vector to the sun, in the world.
vec3 direction_to(const Sun& sun);

// A lat-long picture's place that is seen in a direction of the world, and back. The place is within it, 0 … 1, from its upper
// left corner. The middle of the picture lies at +y, its right at +x, its upper edge overhead.
vec3 direction_of(vec2 place, Angle environment_turn);
vec2 place_of(vec3 direction, Angle environment_turn);

// 2 to the power of `exposure_ev`: what all light is multiplied by.
double exposure_factor(const Light& light);

}  // namespace shatterpave::studio
