// Pictures that hold a field over a plan: numbers for each place, not colours.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shatterpave::scene {

// As many as vectors of a grid (scene/direction_file.h).
inline constexpr std::size_t most_field_pixels = 4'000'000;
// Of that many pixels with four channels of floats.
inline constexpr std::size_t largest_field_bytes = std::size_t{64} << 20;

// Two numbers for each pixel, in rows from the top.
struct PairPicture {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<float> first;
  std::vector<float> second;
};

// Two channels of an OpenEXR picture: those named as the first of `pairs` that it has both of. Of several parts, the first;
// what its data window holds. Throws InputError with `file` where `content` is no such picture, is broken or deep, has more
// than `most_field_pixels`, or has none of the pairs at every pixel.
struct ChannelPair {
  std::string_view first;
  std::string_view second;
};
PairPicture pair_of_exr(const std::string& content, const std::string& file, std::span<const ChannelPair> pairs);

}  // namespace shatterpave::scene
