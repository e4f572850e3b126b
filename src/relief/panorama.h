// Lat-long pictures of all that is around a scene, read from memory.
#pragma once

#include <cstddef>
#include <string>

#include "relief/raster.h"

namespace shatterpave::relief {

inline constexpr std::size_t widest_panorama_px = 8192;

// The picture in `content`, a file of the format that `ending` names ("exr", "hdr" or "png"), as linear red, green and blue. Of
// one channel, all three are that; more than those of colour are left out. PNG is taken for sRGB; EXR and HDR for linear light
// of sRGB's primaries. Values that are no number or below 0 become 0, and those above what a half float holds, that.
// Throws InputError, without a place, where it is no such picture, broken, not twice as wide as high, or wider than
// `widest_panorama_px`.
Raster panorama(const std::string& content, const std::string& ending);

}  // namespace shatterpave::relief
