#include "relief/raster.h"

#include <algorithm>
#include <memory>

#include "core/cancel.h"
#include "core/error.h"
#include "core/functions.h"
#include "core/parallel.h"
#include "relief/openimageio.h"

namespace shatterpave::relief {

namespace {

OIIO::ImageSpec specification(const Raster& raster, RasterFormat format) {
  const bool exr = format == RasterFormat::exr_half || format == RasterFormat::exr_float;
  OIIO::TypeDesc type = OIIO::TypeDesc::UINT8;
  if (format == RasterFormat::png16) type = OIIO::TypeDesc::UINT16;
  if (format == RasterFormat::exr_half) type = OIIO::TypeDesc::HALF;
  if (format == RasterFormat::exr_float) type = OIIO::TypeDesc::FLOAT;
  OIIO::ImageSpec spec(static_cast<int>(raster.width), static_cast<int>(raster.height), static_cast<int>(raster.channels),
                       type);
  if (exr) {
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "");  // or the writer would put the present time here
  }
  if (format == RasterFormat::jpeg) {
    spec.attribute("compression", "jpeg:90");
    spec.attribute("jpeg:subsampling", "4:4:4");
  }
  return spec;
}

constexpr std::size_t rows_between_asks = 64;  // between two questions whether to stop

// Calls `part(begin, end)` for some rows after the others.
template <class Part>
bool all_rows(std::size_t height, const Part& part) {
  for (std::size_t begin = 0; begin < height; begin += rows_between_asks) {
    stop_if_cancelled();
    if (!part(begin, std::min(height, begin + rows_between_asks))) return false;
  }
  return true;
}

float srgb(float linear) {
  const double value = std::clamp(static_cast<double>(linear), 0.0, 1.0);
  return static_cast<float>(value <= 0.0031308 ? 12.92 * value : 1.055 * power(value, 1.0 / 2.4) - 0.055);
}

}  // namespace

std::string encoded(const Raster& raster, RasterFormat format) {
  ENSURE(raster.values.size() == raster.width * raster.height * raster.channels);
  const bool exr = format == RasterFormat::exr_half || format == RasterFormat::exr_float;
  // Picks the writer; no file of that name is made.
  const std::string name = format == RasterFormat::jpeg ? "memory.jpg" : (exr ? "memory.exr" : "memory.png");
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(name, &memory);
  ENSURE(output != nullptr);
  ENSURE(output->open(name, specification(raster, format)));
  ENSURE(all_rows(raster.height, [&](std::size_t begin, std::size_t end) {
    return output->write_scanlines(static_cast<int>(begin), static_cast<int>(end), 0, OIIO::TypeDesc::FLOAT,
                                   &raster.values[begin * raster.width * raster.channels]);
  }));
  ENSURE(output->close());
  return {bytes.begin(), bytes.end()};
}

Raster read_raster(const std::string& path) {
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path);
  const auto fail = [&](const std::string& reason) {
    throw InputError(Place{path, 0, 0, {}}, "expected an image that can be read, got: " + reason);
  };
  if (!input) fail(OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  Raster raster{static_cast<std::size_t>(spec.width),
                static_cast<std::size_t>(spec.height),
                static_cast<std::size_t>(spec.nchannels),
                {}};
  raster.values.resize(raster.width * raster.height * raster.channels);
  const auto read_rows = [&](std::size_t begin, std::size_t end) {
    return input->read_scanlines(0, 0, spec.y + static_cast<int>(begin), spec.y + static_cast<int>(end), 0, 0, spec.nchannels,
                                 OIIO::TypeDesc::FLOAT, &raster.values[begin * raster.width * raster.channels]);
  };
  const bool read = spec.tile_width > 0
                        ? input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, raster.values.data())
                        : all_rows(raster.height, read_rows);
  if (!read) fail(input->geterror());
  return raster;
}

Raster display(const Raster& linear) {
  const std::size_t kept = std::min<std::size_t>(linear.channels, 3);
  Raster shown{linear.width, linear.height, kept, std::vector<float>(linear.width * linear.height * kept)};
  parallel_for(linear.height, [&](std::size_t row) {
    for (std::size_t pixel = row * linear.width; pixel < (row + 1) * linear.width; ++pixel) {
      for (std::size_t channel = 0; channel < kept; ++channel) {
        shown.values[pixel * kept + channel] = srgb(linear.values[pixel * linear.channels + channel]);
      }
    }
  });
  return shown;
}

HeightImage height_image(const HeightField& field) {
  HeightImage image{{field.width, field.height, 1, std::vector<float>(field.heights_mm.size(), 0.0F)}, 0.0, 0.0};
  if (field.heights_mm.empty()) return image;
  const auto extremes = std::ranges::minmax(field.heights_mm);
  const double lowest = extremes.min;
  image.low_mm = lowest;
  image.range_mm = extremes.max - lowest;
  if (image.range_mm == 0.0) return image;
  std::ranges::transform(field.heights_mm, image.raster.values.begin(),
                         [&](double height) { return static_cast<float>((height - lowest) / image.range_mm); });
  return image;
}

}  // namespace shatterpave::relief
