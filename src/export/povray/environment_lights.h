// A lat-long picture as lights that shine from far away, so that a renderer that traces no light from pictures is lit by one,
// and every frame alike.
#pragma once

#include <cstddef>
#include <vector>

#include "core/vec.h"
#include "relief/raster.h"

namespace shatterpave::exporting::povray {

struct FarLight {
  vec3 towards{0.0, 0.0, 1.0};     // unit, in the world, of an environment that is not turned
  vec3 irradiance{0.0, 0.0, 0.0};  // on a surface that looks at it: radiance times solid angle; red, green, blue
};

// At most 2 to the power of `cuts`: the picture is cut in two halves of one brightness, those again, and each is a light
// (Debevec, A Median Cut Algorithm for Light Probe Sampling, 2005). Regions are cut across the longer side, as it is seen; one
// of a single cell, or a black one, is not cut. Black ones give no light.
//
// Guarantees: the irradiances sum to the picture's, and the lights in the order of the cuts depend on the picture alone.
//   panorama  as relief/panorama.h; what is finer than 512 × 256 is summed up in cells first
std::vector<FarLight> far_lights(const relief::Raster& panorama, int cuts);

}  // namespace shatterpave::exporting::povray
