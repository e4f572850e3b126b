// Raster images, and the one place that reads and writes them (by OpenImageIO).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "relief/height_field.h"

namespace shatterpave::relief {

// Values row by row from the top, channels together; linear, 0 black and 1 white.
struct Raster {
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t channels = 1;
  std::vector<float> values;  // width * height * channels

  bool operator==(const Raster&) const = default;
};

enum class RasterFormat {
  png8,       // values 0 … 1 to 0 … 255, as they are: whoever wants sRGB applies `display` first
  png16,      // values 0 … 1 to 0 … 65535, as they are
  exr_half,   // half float, zip
  exr_float,  // float, zip
  jpeg,       // values 0 … 1 to 0 … 255, as they are, nearly: off by one or two. All channels are as fine
};

// The file of that raster in memory. It holds pixels and what is needed to read them: no time, program, path or host.
std::string encoded(const Raster& raster, RasterFormat format);

// The raster of a file that OpenImageIO can read. Throws InputError where it cannot, naming the file.
Raster read_raster(const std::string& path);

// Linear colours as a screen shows them: clipped to 0 … 1 and encoded by the sRGB curve (IEC 61966-2-1). A fourth channel is
// left out.
Raster display(const Raster& linear);

// Heights as grey values, and how to get back: height = low_mm + value * range_mm.
struct HeightImage {
  Raster raster;  // one channel, 0 … 1
  double low_mm = 0.0;
  double range_mm = 0.0;  // 0 where the field is level
};

HeightImage height_image(const HeightField& field);

}  // namespace shatterpave::relief
