#include "relief/panorama.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/functions.h"
#include "core/parallel.h"
#include "relief/openimageio.h"

namespace shatterpave::relief {

namespace {

constexpr float largest_half = 65504.0F;
constexpr std::size_t channels = 3;

[[noreturn]] void refuse(const std::string& expected, const std::string& got) {
  throw InputError("expected " + expected + ", got " + got);
}

using Channels = std::array<int, channels>;

// Which of the file's channels are red, green and blue: by their names, or the only one, or the one of light.
Channels channels_of(const OIIO::ImageSpec& spec) {
  const auto named = [&](std::string_view name) {
    const auto found = std::ranges::find(spec.channelnames, name);
    return found == spec.channelnames.end() ? -1 : static_cast<int>(found - spec.channelnames.begin());
  };
  const Channels colours{named("R"), named("G"), named("B")};
  if (std::ranges::all_of(colours, [](int channel) { return channel >= 0; })) return colours;
  const int grey = spec.nchannels == 1 ? 0 : named("Y");
  if (grey >= 0) return {grey, grey, grey};
  constexpr std::size_t most_named = 8;
  std::string names;
  for (std::size_t i = 0; i < std::min(spec.channelnames.size(), most_named); ++i) {
    names += (i == 0 ? "" : ", ") + spec.channelnames[i];
  }
  if (spec.channelnames.size() > most_named) names += ", …";
  refuse("a picture with the channels R, G and B, or a single one", names);
}

void require_shape(const OIIO::ImageSpec& spec) {
  const auto pixels = [](int width, int height) { return std::to_string(width) + " × " + std::to_string(height) + " px"; };
  const std::string size = pixels(spec.width, spec.height);
  if (spec.width != 2 * spec.height || spec.depth > 1 || spec.deep) refuse("a lat-long picture, twice as wide as high", size);
  constexpr int widest = widest_panorama_px;
  if (spec.width > widest) refuse("a picture of at most " + pixels(widest, widest / 2), size);
}

// In one line.
std::string reason(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return "one that is broken: " + text;
}

float from_srgb(float shown) {
  const auto value = static_cast<double>(shown);
  return static_cast<float>(value <= 0.04045 ? value / 12.92 : power((value + 0.055) / 1.055, 2.4));
}

float within(float value) { return value > 0.0F ? std::min(value, largest_half) : 0.0F; }

}  // namespace

Raster panorama(const std::string& content, const std::string& ending) {
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(content.data()), content.size());  // it only reads
  OIIO::ImageSpec how;
  how.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::Filesystem::IOProxy* proxy = &memory;
  how.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(ending);
  ENSURE(input != nullptr);
  const std::string expected = "a picture that can be read (" + ending + ")";
  OIIO::ImageSpec spec;
  // A name for messages: no such file is looked for.
  if (!input->open("memory." + ending, spec, how)) refuse(expected, reason(input->geterror()));
  require_shape(spec);
  const Channels from = channels_of(spec);

  const auto width = static_cast<std::size_t>(spec.width);
  const auto height = static_cast<std::size_t>(spec.height);
  const int first = *std::ranges::min_element(from);
  const int last = *std::ranges::max_element(from) + 1;
  const auto read = static_cast<std::size_t>(last - first);
  constexpr std::size_t most_read = 8;  // so that no file asks for more memory than its size in pixels does
  if (read > most_read) refuse("a picture with the channels R, G and B beside one another", "others between them");
  std::vector<float> values(width * height * read);
  if (!input->read_image(0, 0, first, last, OIIO::TypeDesc::FLOAT, values.data())) {
    refuse(expected, reason(input->geterror()));
  }
  Raster raster{width, height, channels, std::vector<float>(width * height * channels)};
  parallel_for(height, [&](std::size_t row) {
    for (std::size_t pixel = row * width; pixel < (row + 1) * width; ++pixel) {
      for (std::size_t c = 0; c < channels; ++c) {
        const float value = values[pixel * read + static_cast<std::size_t>(from.at(c) - first)];
        raster.values[pixel * channels + c] = within(ending == "png" ? from_srgb(value) : value);
      }
    }
  });
  return raster;
}

}  // namespace shatterpave::relief
