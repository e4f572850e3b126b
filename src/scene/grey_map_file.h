// Pictures of one grey channel that sizes of stones follow.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"

namespace shatterpave::scene {

struct GreyMapFile {
  std::size_t columns = 0;
  std::vector<float> greys;  // 0 … 1, in rows from the top
  std::string sum;           // SHA-256 of its content
};

// As many as a picture of 4096 by 4096.
inline constexpr std::size_t most_grey_pixels = std::size_t{1} << 24;

// The picture of a PNG file, its levels over the greatest that its depth has, as they are: no gamma. Of a picture in colours,
// the weighted mean that libpng takes; what is transparent counts like what is not. Throws InputError at `place` where there is
// no such file, and with its name where it is no PNG, is broken or has too many pixels.
GreyMapFile grey_map_of_file(const std::filesystem::path& file, const Place& place);

}  // namespace shatterpave::scene
