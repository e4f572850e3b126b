#include "relief/panorama.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "studio/light.h"
#include "studio/plain_sky.h"

namespace shatterpave::relief {
namespace {

Raster picture(std::size_t width, std::size_t height, std::size_t channels, float value) {
  return {width, height, channels, std::vector<float>(width * height * channels, value)};
}

std::string refusal(const std::string& content, const std::string& ending) {
  try {
    panorama(content, ending);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Panorama, OpenExrIsReadAsItIs) {
  Raster given = picture(8, 4, 3, 0.25F);
  given.values[3] = 31744.0F;
  EXPECT_EQ(panorama(encoded(given, RasterFormat::exr_float), "exr"), given);
}

TEST(Panorama, PngIsTakenForSrgb) {
  const Raster read = panorama(encoded(picture(4, 2, 3, 188.0F / 255.0F), RasterFormat::png8), "png");
  ASSERT_EQ(read.values.size(), 24U);
  for (const float value : read.values) EXPECT_NEAR(value, 0.50289F, 1e-4F);
}

TEST(Panorama, OneChannelIsGreyAndAlphaIsLeftOut) {
  EXPECT_EQ(panorama(encoded(picture(4, 2, 1, 0.5F), RasterFormat::exr_half), "exr"), picture(4, 2, 3, 0.5F));
  Raster with_alpha = picture(4, 2, 4, 0.5F);
  for (std::size_t i = 3; i < with_alpha.values.size(); i += 4) with_alpha.values[i] = 0.0F;
  EXPECT_EQ(panorama(encoded(with_alpha, RasterFormat::exr_half), "exr"), picture(4, 2, 3, 0.5F));
  const Raster png = panorama(encoded(with_alpha, RasterFormat::png16), "png");
  for (const float value : png.values) EXPECT_NEAR(value, 0.2140F, 1e-3F);
}

// Where the one of light does not stand first in the file.
TEST(Panorama, LuminanceIsFoundBesideOthers) {
  for (const char* other : {"A", "R", "Z"}) {
    OIIO::ImageSpec spec(4, 2, 2, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {other, "Y"};
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("exr");
    ASSERT_TRUE(output->set_ioproxy(&memory) && output->open("memory.exr", spec));
    std::vector<float> values;
    for (int i = 0; i < 8; ++i) values.insert(values.end(), {0.75F, 0.5F});
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close());
    EXPECT_EQ(panorama(std::string(bytes.begin(), bytes.end()), "exr"), picture(4, 2, 3, 0.5F)) << other;
  }
}

TEST(Panorama, WhatIsNoBrightnessBecomesOne) {
  Raster given = picture(4, 2, 3, 1.0F);
  given.values[0] = std::numeric_limits<float>::quiet_NaN();
  given.values[1] = -3.0F;
  given.values[2] = std::numeric_limits<float>::infinity();
  const Raster read = panorama(encoded(given, RasterFormat::exr_float), "exr");
  EXPECT_EQ(read.values[0], 0.0F);
  EXPECT_EQ(read.values[1], 0.0F);
  EXPECT_EQ(read.values[2], 65504.0F);
}

TEST(Panorama, ThePlainSkyIsWhatItsFormulaSays) {
  const Raster read = panorama(studio::plain_sky_hdr(), "hdr");
  ASSERT_EQ(read.width, 256U);
  ASSERT_EQ(read.height, 128U);
  for (std::size_t y = 0; y < read.height; ++y) {
    for (const std::size_t x : {std::size_t{0}, std::size_t{130}, std::size_t{255}}) {
      const vec3 sky = studio::plain_sky(
          studio::direction_of({(static_cast<double>(x) + 0.5) / 256.0, (static_cast<double>(y) + 0.5) / 128.0}, Angle()));
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(static_cast<double>(read.values[(y * read.width + x) * 3 + c]), sky[c], 0.008) << x << " " << y;
      }
    }
  }
}

TEST(Panorama, RefusesWhatIsNotTwiceAsWideAsHigh) {
  EXPECT_EQ(refusal(encoded(picture(6, 4, 3, 1.0F), RasterFormat::exr_half), "exr"),
            "expected a lat-long picture, twice as wide as high, got 6 × 4 px");
}

TEST(Panorama, RefusesWhatIsTooWideByItsHeaderAlone) {
  EXPECT_EQ(refusal("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 5000 +X 10000\n", "hdr"),
            "expected a picture of at most 8192 × 4096 px, got 10000 × 5000 px");
}

TEST(Panorama, RefusesWhatIsBroken) {
  const auto is_told = [](const std::string& content, const std::string& ending) {
    return refusal(content, ending).find("expected a picture that can be read (" + ending + "), got one that is broken") == 0;
  };
  Raster noise = picture(64, 32, 3, 0.0F);
  for (std::size_t i = 0; i < noise.values.size(); ++i) noise.values[i] = static_cast<float>((i * 7919) % 1009) / 1009.0F;
  for (const auto& [format, ending] : {std::pair(RasterFormat::exr_half, "exr"), std::pair(RasterFormat::png8, "png")}) {
    const std::string whole = encoded(noise, format);
    for (const std::size_t length : {std::size_t{8}, std::size_t{40}, whole.size() / 2, whole.size() - 200}) {
      EXPECT_TRUE(is_told(whole.substr(0, length), ending)) << ending << length << refusal(whole.substr(0, length), ending);
    }
  }
  const std::string sky = studio::plain_sky_hdr();
  EXPECT_TRUE(is_told(sky.substr(0, sky.size() / 2), "hdr"));
  EXPECT_TRUE(is_told("#?RADIANCE\n", "hdr"));
}

}  // namespace
}  // namespace shatterpave::relief
