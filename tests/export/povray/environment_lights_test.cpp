#include "export/povray/environment_lights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "studio/light.h"

namespace shatterpave::exporting::povray {
namespace {

// Noise, five times as light in the upper quarter, with a bright spot.
relief::Raster sky(std::size_t width, std::size_t height) {
  relief::Raster raster{width, height, 3, std::vector<float>(width * height * 3)};
  for (std::size_t i = 0; i < raster.values.size(); ++i) {
    const float value = static_cast<float>((i * 7919) % 1009) / 1009.0F;
    raster.values[i] = 4 * (i / 3 / width) < height ? 5.0F * value : value;
  }
  const std::size_t spot = (height / 4 * width + width / 3) * 3;
  for (std::size_t c = 0; c < 3; ++c) raster.values[spot + c] = 500.0F;
  return raster;
}

struct Sums {
  vec3 irradiance{0.0, 0.0, 0.0};
  vec3 towards{0.0, 0.0, 0.0};  // weighted with the brightness
};

double bright(vec3 colour) { return 0.2126 * colour.x + 0.7152 * colour.y + 0.0722 * colour.z; }

// By the definition; `equal` is the wrong law, in which all pixels are of one size.
Sums sums_of(const relief::Raster& raster, bool equal = false) {
  Sums sums;
  const auto w = static_cast<double>(raster.width);
  const auto h = static_cast<double>(raster.height);
  for (std::size_t y = 0; y < raster.height; ++y) {
    const double top = pi * static_cast<double>(y) / h;
    const double angle = equal ? 4.0 * pi / (w * h) : 2.0 * pi / w * (std::cos(top) - std::cos(top + pi / h));
    for (std::size_t x = 0; x < raster.width; ++x) {
      const float* v = &raster.values[(y * raster.width + x) * 3];
      const vec3 flux = angle * vec3{static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
      sums.irradiance += flux;
      sums.towards += bright(flux) *
                      studio::direction_of({(static_cast<double>(x) + 0.5) / w, (static_cast<double>(y) + 0.5) / h}, Angle());
    }
  }
  return sums;
}

Sums sums_of(const std::vector<FarLight>& lights) {
  Sums sums;
  for (const FarLight& light : lights) {
    sums.irradiance += light.irradiance;
    sums.towards += bright(light.irradiance) * light.towards;
  }
  return sums;
}

TEST(FarLights, SumToThePicturesLight) {
  for (const auto& [width, height] : {std::pair(64, 32), std::pair(1000, 500), std::pair(2, 1)}) {
    const relief::Raster picture = sky(static_cast<std::size_t>(width), static_cast<std::size_t>(height));
    const vec3 all = sums_of(picture).irradiance;
    for (const int cuts : {0, 1, 4, 6}) {
      const vec3 made = sums_of(far_lights(picture, cuts)).irradiance;
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(made[c], all[c], 1e-9 * all[c]) << width << " " << cuts;
    }
    if (height > 1) {
      EXPECT_GT(std::abs(sums_of(picture, true).irradiance.y / all.y - 1.0), 1e-3) << "the twin";
    }
  }
}

TEST(FarLights, ShineFromWhereThePictureDoesInTheMean) {
  const relief::Raster picture = sky(256, 128);
  const Sums all = sums_of(picture);
  const std::vector<FarLight> lights = far_lights(picture, 6);
  EXPECT_EQ(lights.size(), 64U);
  const vec3 off = sums_of(lights).towards - all.towards;
  // A region of a 64th of the sphere is 0.25 rad from its middle to its border: within it directions shorten the sum by 3 %.
  EXPECT_LT(glm::length(off), 0.03 * bright(all.irradiance));
}

TEST(FarLights, HaveAboutTheSameBrightness) {
  relief::Raster even = sky(512, 256);
  for (float& value : even.values) value = std::min(value, 1.0F);
  const std::vector<FarLight> lights = far_lights(even, 4);
  const double mean = bright(sums_of(even).irradiance) / 16.0;
  ASSERT_EQ(lights.size(), 16U);
  for (const FarLight& light : lights) EXPECT_NEAR(bright(light.irradiance), mean, 0.05 * mean);
}

TEST(FarLights, OfOneBrightPixelIsThereAndNowhereElse) {
  relief::Raster picture{64, 32, 3, std::vector<float>(64 * 32 * 3, 0.0F)};
  picture.values[(8 * 64 + 48) * 3 + 1] = 2.0F;
  const std::vector<FarLight> lights = far_lights(picture, 6);
  ASSERT_EQ(lights.size(), 1U);
  EXPECT_LT(glm::length(lights[0].towards - studio::direction_of({48.5 / 64.0, 8.5 / 32.0}, Angle())), 1e-12);
  EXPECT_EQ(lights[0].irradiance.x, 0.0);
  EXPECT_GT(lights[0].irradiance.y, 0.0);
}

TEST(FarLights, OfABlackPictureAreNone) {
  EXPECT_TRUE(far_lights({64, 32, 3, std::vector<float>(64 * 32 * 3, 0.0F)}, 6).empty());
}

}  // namespace
}  // namespace shatterpave::exporting::povray
