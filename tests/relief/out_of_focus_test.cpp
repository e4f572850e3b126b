#include "relief/out_of_focus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/parallel.h"
#include "core/random.h"
#include "core/vec.h"

namespace shatterpave::relief {
namespace {

Raster random_sky(std::size_t height) {
  Raster sky{2 * height, height, 3, std::vector<float>(2 * height * height * 3)};
  for (std::size_t i = 0; i < sky.values.size(); ++i) {
    sky.values[i] = static_cast<float>(uniform(5, {Stream::relief_lattice, Id("sky").child(i)}));
  }
  return sky;
}

Angle elevation_of(double row, std::size_t height) {
  return Angle::radians(pi * (0.5 - (row + 0.5) / static_cast<double>(height)));
}

vec3 direction(double column, double row, std::size_t height) {
  const vec2 upward = elevation_of(row, height).direction();
  const vec2 level = Angle::radians(pi * (column + 0.5) / static_cast<double>(height)).direction();
  return {upward.x * level.x, upward.x * level.y, upward.y};
}

// The mean over a disc by looking at every one of many small parts of the picture.
double mean_by_parts(const Raster& sky, vec3 towards, Angle radius, std::size_t channel) {
  constexpr std::size_t parts = 12;
  double sum = 0.0;
  double area = 0.0;
  const std::size_t height = parts * sky.height;
  for (std::size_t row = 0; row < height; ++row) {
    const double weight = elevation_of(static_cast<double>(row), height).direction().x;
    for (std::size_t column = 0; column < 2 * height; ++column) {
      const vec3 there = direction(static_cast<double>(column), static_cast<double>(row), height);
      if (glm::dot(there, towards) < radius.direction().x) continue;
      sum += weight * static_cast<double>(sky.values[((row / parts) * sky.width + column / parts) * sky.channels + channel]);
      area += weight;
    }
  }
  return sum / area;
}

double total(const Raster& sky) {
  double sum = 0.0;
  for (std::size_t row = 0; row < sky.height; ++row) {
    const double weight = elevation_of(static_cast<double>(row), sky.height).direction().x;
    for (std::size_t i = 0; i < sky.width * sky.channels; ++i) {
      sum += weight * static_cast<double>(sky.values[row * sky.width * sky.channels + i]);
    }
  }
  return sum / static_cast<double>(sky.height * sky.height);
}

TEST(OutOfFocus, HoldsTheMeanOverADiscAboutEachDirection) {
  const Raster sky = random_sky(16);
  for (const double diameter_deg : {9.0, 20.0, 60.0}) {
    const Raster blurred = out_of_focus(sky, Angle::degrees(diameter_deg));
    ASSERT_EQ(blurred.width, 2 * blurred.height);
    // From pole to pole, and across the seam.
    for (const double down : {0.0, 0.04, 0.3, 0.5, 0.8, 0.999}) {
      for (const double across : {0.0, 0.37, 0.999}) {
        const auto row = static_cast<std::size_t>(down * static_cast<double>(blurred.height));
        const auto column = static_cast<std::size_t>(across * static_cast<double>(blurred.width));
        const vec3 towards = direction(static_cast<double>(column), static_cast<double>(row), blurred.height);
        const double expected = mean_by_parts(sky, towards, Angle::degrees(0.5 * diameter_deg), 1);
        EXPECT_NEAR(blurred.values[(row * blurred.width + column) * 3 + 1], expected, 0.02)
            << diameter_deg << "° at " << down << ", " << across;
      }
    }
  }
}

TEST(OutOfFocus, KeepsTheLightFromAllAround) {
  for (const std::size_t height : {16U, 64U, 256U}) {
    const Raster sky = random_sky(height);
    for (const double diameter_deg : {4.0, 60.0}) {
      const Raster blurred = out_of_focus(sky, Angle::degrees(diameter_deg));
      EXPECT_NEAR(total(blurred), total(sky), 0.01 * total(sky)) << height << ", " << diameter_deg;
    }
  }
}

TEST(OutOfFocus, MakesDiscsOfPointsOfLight) {
  // On the horizon, and high up, where a lat-long picture is drawn out.
  for (const std::size_t row : {64U, 12U}) {
    Raster sky{256, 128, 1, std::vector<float>(256 * 128)};
    sky.values[row * 256 + 100] = 1000.0F;
    const Raster blurred = out_of_focus(sky, Angle::degrees(10.0));
    double lit = 0.0;
    for (std::size_t y = 0; y < blurred.height; ++y) {
      for (std::size_t x = 0; x < blurred.width; ++x) {
        if (blurred.values[y * blurred.width + x] > 0.0F)
          lit += elevation_of(static_cast<double>(y), blurred.height).direction().x;
      }
    }
    const double pixel = pi / static_cast<double>(blurred.height);
    const double disc = 2.0 * pi * (1.0 - Angle::degrees(5.0).direction().x);
    // The pixel that the light comes from is 1.4° wide on the horizon.
    EXPECT_GT(lit * pixel * pixel, disc);
    EXPECT_LT(lit * pixel * pixel, 1.45 * disc);
  }
}

TEST(OutOfFocus, WithoutADiscIsThePictureItself) {
  const Raster sky = random_sky(8);
  EXPECT_EQ(out_of_focus(sky, Angle()), sky);
}

TEST(OutOfFocus, OfFinePicturesUnderWideDiscsIsTheSameAsOfCoarseOnes) {
  Raster coarse{512, 256, 3, std::vector<float>(512 * 256 * 3)};
  Raster fine{2048, 1024, 3, std::vector<float>(2048 * 1024 * 3)};
  for (std::size_t i = 0; i < fine.values.size(); ++i) {
    const std::size_t pixel = i / 3;
    const std::size_t at = ((pixel / 2048 / 4) * 512 + pixel % 2048 / 4) * 3 + i % 3;
    // Another pattern in each channel, and darker to the right.
    coarse.values[at] = static_cast<float>(at % (67 + 15 * (i % 3))) * (1.0F - static_cast<float>(pixel % 2048) / 4096.0F);
  }
  for (std::size_t i = 0; i < fine.values.size(); ++i) {
    const std::size_t pixel = i / 3;
    fine.values[i] = coarse.values[((pixel / 2048 / 4) * 512 + pixel % 2048 / 4) * 3 + i % 3];
  }
  const Raster expected = out_of_focus(coarse, Angle::degrees(40.0));
  const Raster found = out_of_focus(fine, Angle::degrees(40.0));
  ASSERT_EQ(found.values.size(), expected.values.size());
  for (std::size_t i = 0; i < found.values.size(); ++i) ASSERT_NEAR(found.values[i], expected.values[i], 0.5);
}

TEST(OutOfFocus, IsTheSameForAnyNumberOfThreadsParallel) {
  const Raster sky = random_sky(64);
  Raster one;
  with_threads(1, [&] { one = out_of_focus(sky, Angle::degrees(4.0)); });
  for (const int threads : {2, 7}) {
    with_threads(threads, [&] { EXPECT_EQ(out_of_focus(sky, Angle::degrees(4.0)), one); });
  }
}

}  // namespace
}  // namespace shatterpave::relief
