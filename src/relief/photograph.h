// Photographs: pictures as cameras and scanners give them, and the one that is drawn over.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace shatterpave::relief {

// Red, green and blue of each pixel, 0 … 255 as a screen shows them, row by row from the top, the way up that its file asks
// for.
struct Photograph {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  // 3 * width * height

  bool operator==(const Photograph&) const = default;
};

// Of a photograph that is read: both sides together, so that a file of a few bytes cannot take all memory.
inline constexpr std::int64_t most_photograph_pixels = 50'000'000;
inline constexpr int least_photograph_side = 64;  // px: below, a line of a pixel is a fiftieth of the pane

// The photograph of a file. What is transparent is black; linear values (OpenEXR, Radiance) get the sRGB curve. Throws
// InputError, naming the file, where it cannot be read, or is smaller or larger than these limits: known before it is decoded.
Photograph read_photograph(const std::string& path);

// The file of that picture in memory: PNG, without a time, program or path.
std::string encoded_png(const Photograph& photograph);

// Grey levels 0 … 255: 0.299 R + 0.587 G + 0.114 B (ITU-R BT.601), rounded.
std::vector<std::uint8_t> grey_levels(const Photograph& photograph);

}  // namespace shatterpave::relief
