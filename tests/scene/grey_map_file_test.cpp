#include "scene/grey_map_file.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene/read_scene.h"
#include "support/temporary_folder.h"

namespace shatterpave::scene {
namespace {

namespace fs = std::filesystem;

// A PNG as libpng writes it.
template <typename Level>
std::string png_of(png_uint_32 format, png_uint_32 columns, png_uint_32 rows, const std::vector<Level>& levels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = columns;
  image.height = rows;
  image.format = format;
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&image, nullptr, &size, 0, levels.data(), 0, nullptr);
  std::string content(size, '\0');
  png_image_write_to_memory(&image, content.data(), &size, 0, levels.data(), 0, nullptr);
  content.resize(size);
  return content;
}

std::string grey_png(png_uint_32 columns, png_uint_32 rows, const std::vector<std::uint8_t>& levels) {
  return png_of(PNG_FORMAT_GRAY, columns, rows, levels);
}

class GreyMapFiles : public support::FolderTest {
 protected:
  GreyMapFile read(const std::string& content) const {
    std::ofstream(folder_ / "m.png", std::ios::binary) << content;
    return grey_map_of_file(folder_ / "m.png", Place{"s.toml", 7, 3, "map_file"});
  }
  std::string refusal(const std::string& content) const {
    try {
      static_cast<void>(read(content));
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }
};

TEST_F(GreyMapFiles, LevelsAreTakenAsTheyAre) {
  const GreyMapFile bytes = read(grey_png(3, 2, {0, 51, 102, 153, 204, 255}));
  EXPECT_EQ(bytes.columns, 3U);
  EXPECT_EQ(bytes.greys, (std::vector<float>{0.0F, 0.2F, 0.4F, 0.6F, 0.8F, 1.0F}));
  // Of 16 bits, whatever gamma it names.
  const GreyMapFile words = read(png_of<std::uint16_t>(PNG_FORMAT_LINEAR_Y, 3, 1, {0, 13107, 65535}));
  EXPECT_EQ(words.greys, (std::vector<float>{0.0F, 0.2F, 1.0F}));
  EXPECT_NE(bytes.sum, words.sum);
  // Greys in a picture of colours; and what is transparent counts like what is not.
  EXPECT_EQ(read(png_of<std::uint8_t>(PNG_FORMAT_RGB, 2, 1, {51, 51, 51, 255, 255, 255})).greys,
            (std::vector<float>{0.2F, 1.0F}));
  EXPECT_EQ(read(png_of<std::uint8_t>(PNG_FORMAT_GA, 2, 1, {51, 0, 255, 255})).greys, (std::vector<float>{0.2F, 1.0F}));
}

TEST_F(GreyMapFiles, WhatIsNoPictureIsRefused) {
  EXPECT_NE(refusal("P2 1 1 255 0").find("m.png: expected a PNG picture, got"), std::string::npos);
  EXPECT_NE(refusal("").find("expected a PNG picture"), std::string::npos);
  const std::string sound = grey_png(64, 64, std::vector<std::uint8_t>(64 * 64, 7));
  for (std::size_t size = 0; size + 12 < sound.size(); ++size) {
    EXPECT_NE(refusal(sound.substr(0, size)), "none") << size;
  }
  // A byte of its head or its pixels changed: the sums of the chunks tell. What else is in between may be passed over.
  const std::size_t pixels = sound.find("IDAT");
  for (std::size_t at = 0; at + 12 < sound.size(); ++at) {
    constexpr std::size_t head_end = 33;
    if (at >= head_end && at < pixels - 4) continue;
    std::string changed = sound;
    changed[at] = static_cast<char>(changed[at] ^ 4);
    EXPECT_NE(refusal(changed), "none") << at;
  }
  const std::string large = grey_png(4097, 4096, std::vector<std::uint8_t>(std::size_t{4097} * 4096, 7));
  EXPECT_NE(refusal(large).find("at most 16777216 pixels, got 4097 x 4096"), std::string::npos);
}

TEST_F(GreyMapFiles, AScenePutsItOverItsPlan) {
  std::ofstream(folder_ / "m.png", std::ios::binary) << grey_png(2, 1, {0, 255});
  const auto pavement_of = [&](const std::string& size) {
    std::ofstream(folder_ / "s.toml") << "[[pavement]]\nname = \"p\"\nsize_mm = [2000, 1000]\n[pavement.size]\n" + size;
    return scene_of_file(folder_ / "s.toml", {}).pavements.front();
  };
  const auto map = std::get<paving::SizesOfMap>(
      pavement_of("kind = \"map\"\nmap_file = \"m.png\"\ndark = 0.5\nlight = 2\nmap_area_mm = [[0, 0], [500, 400]]\n").sizes);
  EXPECT_EQ(map.dark, 0.5);
  EXPECT_EQ(map.light, 2.0);
  EXPECT_EQ(map.high_mm, (vec2{500, 400}));
  EXPECT_EQ(map.greys, (std::vector<float>{0.0F, 1.0F}));
  const auto whole = std::get<paving::SizesOfMap>(pavement_of("kind = \"map\"\nmap_file = \"m.png\"\n").sizes);
  EXPECT_EQ(whole.high_mm - whole.low_mm, (vec2{2000, 1000}));
  EXPECT_THROW(static_cast<void>(pavement_of("kind = \"map\"\n")), InputError);
  EXPECT_THROW(static_cast<void>(pavement_of("kind = \"line\"\n")), InputError);
  EXPECT_THROW(static_cast<void>(pavement_of("kind = \"edge\"\nnear = 0.2\n")), InputError);
}

TEST(SizesAndCells, StandOnlyWhereTheyHaveAMeaning) {
  const auto refusal = [](const std::string& keys) {
    try {
      static_cast<void>(scene_of_text("[[pavement]]\nname = \"p\"\nsize_mm = [2000, 1000]\n" + keys, "s.toml"));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  const auto expect = [&](const std::string& keys, std::string_view part) {
    EXPECT_NE(refusal(keys).find(part), std::string::npos) << keys << refusal(keys);
  };
  expect("[pavement.size]\nkind = \"edge\"\nfar = 2\n", "none");
  expect("bond = \"running\"\n[pavement.size]\nfar = 2\n", "bond = \"packed\" beside size");
  expect("[pavement.size]\nfar = 2\n[pavement.steps]\n", "no steps beside size");
  expect("[pavement.cell]\nform = \"scale\"\n", "none");
  expect("bond = \"stack\"\n[pavement.cell]\nform = \"cobble\"\n", "none");
  expect("bond = \"stack\"\n[pavement.cell]\nform = \"scale\"\n", "bond = \"packed\" beside cell.form = \"scale\"");
  expect("stone_mm = [200, 100]\n[pavement.cell]\nform = \"scale\"\n", "square stones beside cell.form");
  expect("[pavement.surface]\nfinish = \"split\"\n[pavement.cell]\nform = \"cobble\"\n", "no finish beside cell.form");
  expect("border_course = \"soldier\"\n[pavement.cell]\nform = \"cobble\"\n", "no border_course beside cell.form");
}

}  // namespace
}  // namespace shatterpave::scene
