// Swatches: they meet themselves, are of their material, and the same everywhere.
#include "export/swatches/swatches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "export/shapes/bodies.h"

namespace shatterpave::exporting::swatches {
namespace {

using paving::Material;
using shapes::Swatch;
using shapes::SwatchOf;

Swatch swatch_of(Material material, std::size_t size_px = 256) {
  Swatch swatch;
  swatch.name = "stone";
  swatch.look.material = material;
  swatch.size_px = size_px;
  return swatch;
}

constexpr std::array materials = {Material::setts,     Material::granite,   Material::basalt,
                                  Material::sandstone, Material::limestone, Material::brick};

Swatch joint_of(paving::JointFill fill, std::size_t size_px = 256) {
  Swatch swatch;
  swatch.of = SwatchOf::joint;
  swatch.look.joint_fill = fill;
  swatch.side_m = 0.5;
  swatch.size_px = size_px;
  return swatch;
}

// The mean difference between a column and the next, of all channels.
double step_between(const relief::Raster& raster, std::size_t column, std::size_t next) {
  double sum = 0.0;
  for (std::size_t row = 0; row < raster.height; ++row) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum += std::abs(static_cast<double>(raster.values[3 * (row * raster.width + column) + c]) -
                      static_cast<double>(raster.values[3 * (row * raster.width + next) + c]));
    }
  }
  return sum / static_cast<double>(3 * raster.height);
}

relief::Raster transposed(const relief::Raster& raster) {
  relief::Raster result = raster;
  for (std::size_t y = 0; y < raster.height; ++y) {
    for (std::size_t x = 0; x < raster.width; ++x) {
      for (std::size_t c = 0; c < 3; ++c)
        result.values[3 * (x * raster.height + y) + c] = raster.values[3 * (y * raster.width + x) + c];
    }
  }
  return result;
}

// How much larger the step from the last column to the first is than those between others: 1 where it shows no seam.
double seam(const relief::Raster& raster) {
  double inner = 0.0;
  for (std::size_t column = 0; column + 1 < raster.width; ++column) inner += step_between(raster, column, column + 1);
  inner /= static_cast<double>(raster.width - 1);
  return step_between(raster, raster.width - 1, 0) / inner;
}

void expect_seamless(const relief::Raster& raster, const std::string& what) {
  EXPECT_LT(seam(raster), 1.25) << what;
  EXPECT_LT(seam(transposed(raster)), 1.25) << what;
}

TEST(Swatches, MeetThemselvesOnAllSides) {
  std::vector<Swatch> all = {joint_of(paving::JointFill::sand), joint_of(paving::JointFill::mortar)};
  for (const Material material : materials) all.push_back(swatch_of(material));
  for (const Swatch& swatch : all) {
    const std::string what =
        std::to_string(static_cast<int>(swatch.of)) + std::to_string(static_cast<int>(swatch.look.material));
    const Pictures pictures = drawn(swatch, 7);
    expect_seamless(pictures.base_color, what + " colour");
    expect_seamless(pictures.normal, what + " normal");
    expect_seamless(pictures.occlusion_roughness_metallic, what + " surface");
  }
}

// The twin: half a swatch does not meet itself.
TEST(Swatches, OfWhichAPartIsLeftOutShowASeam) {
  const relief::Raster whole = drawn(swatch_of(Material::brick), 7).base_color;
  relief::Raster half{whole.width / 2, whole.height, 3, {}};
  for (std::size_t y = 0; y < whole.height; ++y) {
    const auto row = whole.values.begin() + static_cast<std::ptrdiff_t>(3 * y * whole.width);
    half.values.insert(half.values.end(), row, row + static_cast<std::ptrdiff_t>(3 * half.width));
  }
  EXPECT_GT(seam(half), 1.5);
}

struct Spread {
  double mean = 0.0;
  double deviation = 0.0;
};

Spread spread(const relief::Raster& raster, std::size_t channel) {
  double sum = 0.0;
  double squares = 0.0;
  const std::size_t count = raster.width * raster.height;
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = static_cast<double>(raster.values[3 * i + channel]);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / static_cast<double>(count);
  return {mean, std::sqrt(std::max(0.0, squares / static_cast<double>(count) - mean * mean))};
}

// Times the tint of a tone the mean of a swatch is near the colour that the tone has without, which for sandstone is that of a
// dark bed: so pavements look alike either way.
TEST(Swatches, HaveTheColoursOfTheirMaterial) {
  for (const Material material : materials) {
    const Swatch swatch = swatch_of(material);
    const shapes::Palette palette(swatch.look);
    const shapes::StoneLook tone = palette.stone(0.4);
    const relief::Raster tints = tinted(drawn(swatch, 7).base_color, palette.tint(tone));
    const shapes::Colour plain = palette.stone_colour(tone, {});
    EXPECT_NEAR(spread(tints, 0).mean / static_cast<double>(plain.red), 1.0, 0.2) << static_cast<int>(material);
    EXPECT_NEAR(spread(tints, 1).mean / static_cast<double>(plain.green), 1.0, 0.2) << static_cast<int>(material);
    EXPECT_GT(spread(tints, 1).deviation, 0.05 * spread(tints, 1).mean);  // grain
    for (int k = 0; k < 24; ++k) {
      const shapes::StoneLook look = palette.stone((k + 0.5) / 24.0);
      const shapes::Colour tint = palette.tint(look);
      EXPECT_LE(std::max({tint.red, tint.green, tint.blue}), 1.0F);
      EXPECT_LE(palette.roughness_part(look), 1.0F);
    }
  }
}

TEST(Swatches, AreOfStoneAndOpen) {
  const Pictures pictures = drawn(swatch_of(Material::granite), 7);
  EXPECT_NEAR(spread(pictures.normal, 0).mean, 0.5, 0.01);
  EXPECT_NEAR(spread(pictures.normal, 1).mean, 0.5, 0.01);
  EXPECT_GT(spread(pictures.normal, 2).mean, 0.9);
  EXPECT_GT(spread(pictures.normal, 0).deviation, 0.01);
  EXPECT_GT(spread(pictures.occlusion_roughness_metallic, 0).mean, 0.8);
  EXPECT_NEAR(spread(pictures.occlusion_roughness_metallic, 1).mean, 0.68, 0.1);
  EXPECT_EQ(spread(pictures.occlusion_roughness_metallic, 2).mean, 0.0);  // no metal
  // Without relief the surface is level.
  Swatch level = swatch_of(Material::granite);
  level.relief.rms_mm = 0.0;
  EXPECT_EQ(spread(drawn(level, 7).normal, 0).deviation, 0.0);
  EXPECT_EQ(spread(drawn(level, 7).occlusion_roughness_metallic, 0).mean, 1.0);
}

TEST(Swatches, AreAsRoughAsTheRelief) {
  const Swatch swatch = swatch_of(Material::basalt, 512);
  const Pictures pictures = drawn(swatch, 7);
  Swatch other = swatch;
  other.relief.rms_mm *= 2.0;  // the same surface, twice as high
  const Pictures higher = drawn(other, 7);
  EXPECT_GT(spread(higher.normal, 0).deviation, 1.5 * spread(pictures.normal, 0).deviation);
}

TEST(SwatchesInParallel, AreTheSameBytesForAnyNumberOfThreads) {
  const auto bytes = [&](int threads) {
    const ThreadLimit limit(threads);
    const Files made = files(drawn(swatch_of(Material::limestone, 200), 7), "stone");
    return made.base_color.bytes + made.normal.bytes + made.occlusion_roughness_metallic.bytes;
  };
  const std::string one = bytes(1);
  EXPECT_EQ(one, bytes(2));
  EXPECT_EQ(one, bytes(7));
}

TEST(Swatches, AreNamedFilesThatReadersKnow) {
  const Files made = files(drawn(swatch_of(Material::brick, 64), 7), "brick_2");
  EXPECT_EQ(made.base_color.name, "brick_2_BaseColor.jpg");
  EXPECT_EQ(made.normal.name, "brick_2_Normal.jpg");
  EXPECT_EQ(made.occlusion_roughness_metallic.name, "brick_2_OcclusionRoughnessMetallic.jpg");
  for (const PictureFile* file : {&made.base_color, &made.normal, &made.occlusion_roughness_metallic}) {
    EXPECT_EQ(file->media_type, "image/jpeg");
    EXPECT_TRUE(file->bytes.starts_with("\xFF\xD8\xFF"));
  }
}

TEST(Swatches, BearOddSizes) {
  for (const std::size_t size_px : {1U, 2U, 3U, 100U}) {
    EXPECT_EQ(drawn(swatch_of(Material::sandstone, size_px), 7).normal.values.size(), 3 * size_px * size_px);
    EXPECT_FALSE(files(drawn(joint_of(paving::JointFill::sand, size_px), 7), "s").base_color.bytes.empty());
  }
}

}  // namespace
}  // namespace shatterpave::exporting::swatches
