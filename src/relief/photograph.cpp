#include "relief/photograph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include "core/error.h"
#include "core/parallel.h"
#include "relief/openimageio.h"
#include "relief/raster.h"

namespace shatterpave::relief {

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& expected, const std::string& got) {
  throw InputError(Place{path, 0, 0, {}}, "expected " + expected + ", got " + got);
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

void require_size(const std::string& path, const OIIO::ImageSpec& spec) {
  const auto size = [](int width, int height) { return std::to_string(width) + " x " + std::to_string(height) + " px"; };
  if (spec.width < least_photograph_side || spec.height < least_photograph_side) {
    refuse(path, "a photograph of at least " + size(least_photograph_side, least_photograph_side),
           size(spec.width, spec.height));
  }
  if (std::int64_t{spec.width} * spec.height > most_photograph_pixels || spec.depth > 1) {
    refuse(path, "a photograph of at most " + std::to_string(most_photograph_pixels / 1'000'000) + " megapixels",
           size(spec.width, spec.height));
  }
}

bool is_linear(const OIIO::ImageSpec& spec) {
  return spec.format == OIIO::TypeDesc::FLOAT || spec.format == OIIO::TypeDesc::HALF;
}

// Where the pixel at (x, y) of the file's picture is seen (EXIF 2.3, tag Orientation).
std::array<int, 2> seen_at(int orientation, int x, int y, int width, int height) {
  switch (orientation) {
    case 2:
      return {width - 1 - x, y};
    case 3:
      return {width - 1 - x, height - 1 - y};
    case 4:
      return {x, height - 1 - y};
    case 5:
      return {y, x};
    case 6:
      return {height - 1 - y, x};
    case 7:
      return {height - 1 - y, width - 1 - x};
    case 8:
      return {y, width - 1 - x};
    default:
      return {x, y};
  }
}

struct Shape {
  int width = 0;
  int height = 0;
  int channels = 1;
};

// Three channels of those of the file: grey three times, or the first three.
Photograph colours(const std::vector<std::uint8_t>& values, const Shape& spec, int orientation) {
  const bool turned = orientation >= 5 && orientation <= 8;
  Photograph result{
      turned ? spec.height : spec.width, turned ? spec.width : spec.height,
      std::vector<std::uint8_t>(3 * static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height))};
  const auto channels = static_cast<std::size_t>(spec.channels);
  for (int y = 0; y < spec.height; ++y) {
    for (int x = 0; x < spec.width; ++x) {
      const std::uint8_t* from =
          &values[(static_cast<std::size_t>(y) * static_cast<std::size_t>(spec.width) + static_cast<std::size_t>(x)) *
                  channels];
      const auto [u, v] = seen_at(orientation, x, y, spec.width, spec.height);
      std::uint8_t* to =
          &result.rgb[3 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(result.width) + static_cast<std::size_t>(u))];
      for (std::size_t c = 0; c < 3; ++c) to[c] = from[channels >= 3 ? c : 0];
    }
  }
  return result;
}

std::vector<std::uint8_t> shown(const Raster& linear) {
  const Raster screen = display(linear);
  std::vector<std::uint8_t> values(screen.values.size());
  std::ranges::transform(screen.values, values.begin(),
                         [](float value) { return static_cast<std::uint8_t>(std::lround(255.0F * value)); });
  return values;
}

std::vector<std::uint8_t> levels(OIIO::ImageInput& input, const std::string& path) {
  const OIIO::ImageSpec& spec = input.spec();
  std::vector<std::uint8_t> values(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, values.data())) {
    refuse(path, "a photograph that can be read", first_line(input.geterror()));
  }
  // Of a JPEG or a TIFF that was cut off the rest is made up, and reading succeeds. Bytes between the parts of a JPEG, as some
  // cameras write them, change nothing.
  const std::string told = input.geterror();
  if (!told.empty() && told.find("extraneous bytes") == std::string::npos) {
    refuse(path, "a photograph that can be read to its end", first_line(told));
  }
  return values;
}

}  // namespace

Photograph read_photograph(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) refuse(path, "a photograph", "no file of that name");
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path);
  if (!input) refuse(path, "a photograph that can be read", first_line(OIIO::geterror()));
  const OIIO::ImageSpec& spec = input->spec();
  require_size(path, spec);
  if (spec.nchannels < 1 || spec.nchannels > 64) refuse(path, "1 to 64 channels", std::to_string(spec.nchannels));
  const int orientation = spec.get_int_attribute("Orientation", 1);
  if (!is_linear(spec)) return colours(levels(*input, path), {spec.width, spec.height, spec.nchannels}, orientation);
  return colours(shown(read_raster(path)), {spec.width, spec.height, std::min(spec.nchannels, 3)}, orientation);
}

std::string encoded_png(const Photograph& photograph) {
  Raster raster{static_cast<std::size_t>(photograph.width), static_cast<std::size_t>(photograph.height), 3, {}};
  raster.values.resize(photograph.rgb.size());
  std::ranges::transform(photograph.rgb, raster.values.begin(),
                         [](std::uint8_t value) { return static_cast<float>(value) / 255.0F; });
  return encoded(raster, RasterFormat::png8);
}

std::vector<std::uint8_t> grey_levels(const Photograph& photograph) {
  std::vector<std::uint8_t> grey(photograph.rgb.size() / 3);
  parallel_for_chunks(grey.size(), 1U << 16U, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const unsigned sum = 299U * photograph.rgb[3 * i] + 587U * photograph.rgb[3 * i + 1] + 114U * photograph.rgb[3 * i + 2];
      grey[i] = static_cast<std::uint8_t>((sum + 500U) / 1000U);
    }
  });
  return grey;
}

}  // namespace shatterpave::relief
