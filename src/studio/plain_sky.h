// What is all around where a scene names no environment: a bright, cloudless sky over grey ground, without a sun.
#pragma once

#include <string>

#include "core/vec.h"

namespace shatterpave::studio {

// Radiance in a direction, linear, of the primaries of sRGB. The sky throws about as much on level ground as one of radiance 1
// all over does.
vec3 plain_sky(vec3 direction);

// The same as a lat-long picture (light.h), in Radiance's format (RGBE), 256 × 128.
std::string plain_sky_hdr();

}  // namespace shatterpave::studio
