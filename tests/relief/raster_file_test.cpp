#include "relief/raster_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "relief/raster.h"
#include "support/temporary_folder.h"

namespace shatterpave::relief {
namespace {

namespace fs = std::filesystem;

class RasterFileTest : public support::FolderTest {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
};

// Sixty-fourths, which half and float hold exactly.
std::vector<float> values(const RasterFileShape& shape) {
  std::vector<float> result;
  for (std::size_t i = 0; i < shape.width * shape.height * shape.channels; ++i) {
    result.push_back(static_cast<float>(i * 7 % 64) / 64.0F);
  }
  return result;
}

// In pieces of as many rows as `rows`.
void write(RasterFile& file, const RasterFileShape& shape, std::size_t rows) {
  const std::vector<float> all = values(shape);
  const std::size_t length = shape.width * shape.channels;
  for (std::size_t row = 0; row < shape.height; row += rows) {
    file.append(std::span<const float>(all).subspan(row * length, std::min(rows, shape.height - row) * length));
  }
  file.close();
}

std::string bytes_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST_F(RasterFileTest, IsReadBackAsWrittenWhateverThePieces) {
  const RasterFileShape shape{37, 21, 3};
  for (const std::size_t rows : {1UL, 5UL, 21UL}) {
    RasterFile half(path("h.exr"), shape, RasterFileFormat::exr_half);
    write(half, shape, rows);
    EXPECT_EQ(read_raster(path("h.exr")).values, values(shape)) << rows;
    RasterFile png(path("p.png"), shape, RasterFileFormat::png16);
    write(png, shape, rows);
    const Raster read = read_raster(path("p.png"));
    for (std::size_t i = 0; i < read.values.size(); ++i) ASSERT_NEAR(read.values[i], values(shape)[i], 0.51F / 65535.0F);
  }
}

TEST_F(RasterFileTest, MipMapsAreTheMeansOfFourDownToOnePixel) {
  const RasterFileShape shape{150, 70, 1};
  RasterFile file(path("t.exr"), shape, RasterFileFormat::exr_float, Smaller::mean);
  write(file, shape, 13);
  const auto input = OIIO::ImageInput::open(path("t.exr"));
  ASSERT_TRUE(input);
  EXPECT_EQ(input->spec().tile_width, 64);
  std::vector<float> larger = values(shape);
  int width = 150;
  int height = 70;
  int levels = 1;
  for (; input->seek_subimage(0, levels); ++levels) {
    const int wide = width;
    width = std::max(1, width / 2);
    height = std::max(1, height / 2);
    ASSERT_EQ(input->spec(0, levels).width, width);
    ASSERT_EQ(input->spec(0, levels).height, height);
    std::vector<float> level(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    ASSERT_TRUE(input->read_image(0, levels, 0, 1, OIIO::TypeDesc::FLOAT, level.data()));
    const auto length = static_cast<std::size_t>(wide);
    const std::size_t right = wide > 1 ? 1 : 0;
    const std::size_t down = larger.size() > length ? length : 0;
    for (std::size_t i = 0; i < level.size(); ++i) {
      const std::size_t at = 2 * (i / static_cast<std::size_t>(width)) * length + 2 * (i % static_cast<std::size_t>(width));
      ASSERT_FLOAT_EQ(level[i], 0.25F * (larger[at] + larger[at + right] + larger[at + down] + larger[at + down + right]));
    }
    larger = level;
  }
  EXPECT_EQ(levels, 8);  // 150, 75, 37, 18, 9, 4, 2, 1
}

TEST_F(RasterFileTest, NumbersThatStandForSomethingAreNotMixed) {
  const RasterFileShape shape{64, 64, 1};
  RasterFile file(path("n.exr"), shape, RasterFileFormat::exr_float, Smaller::first);
  write(file, shape, 64);
  const auto input = OIIO::ImageInput::open(path("n.exr"));
  ASSERT_TRUE(input);
  std::vector<float> level(32 * 32);
  ASSERT_TRUE(input->read_image(0, 1, 0, 1, OIIO::TypeDesc::FLOAT, level.data()));
  for (std::size_t y = 0; y < 32; ++y) {
    for (std::size_t x = 0; x < 32; ++x) ASSERT_EQ(level[y * 32 + x], values(shape)[2 * y * 64 + 2 * x]);
  }
}

TEST_F(RasterFileTest, FilesHoldNoTimeAndNoProgram) {
  const RasterFileShape shape{70, 70, 3};
  RasterFile png(path("a.png"), shape, RasterFileFormat::png8);
  write(png, shape, 70);
  RasterFile exr(path("a.exr"), shape, RasterFileFormat::exr_half);
  write(exr, shape, 70);
  RasterFile tiled(path("b.exr"), shape, RasterFileFormat::exr_half, Smaller::mean);
  write(tiled, shape, 70);
  const std::string empty_date("capDate\0string\0\0\0\0\0", 19);
  EXPECT_NE(bytes_of(path("a.exr")).find(empty_date), std::string::npos);
  EXPECT_NE(bytes_of(path("b.exr")).find(empty_date), std::string::npos);
  for (const char* name : {"a.png", "a.exr", "b.exr"}) {
    for (const char* word : {"Software", "software", "DateTime", "OpenImageIO", "hostComputer", "tIME", "shatterpave-test"}) {
      EXPECT_EQ(bytes_of(path(name)).find(word), std::string::npos) << name << " " << word;
    }
  }
}

TEST_F(RasterFileTest, WhatCannotBeWrittenIsAnErrorThatNamesTheFile) {
  try {
    RasterFile file(path("no/such/folder.png"), {4, 4, 1}, RasterFileFormat::png8);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("folder.png"), std::string::npos) << error.what();
  }
}

// As when a run is told to end, or another file of it fails.
TEST_F(RasterFileTest, IsSilentWhereItIsLeftUnfinished) {
  testing::internal::CaptureStderr();
  for (const RasterFileFormat format : {RasterFileFormat::png8, RasterFileFormat::png16, RasterFileFormat::exr_half}) {
    for (const std::size_t rows : {0U, 1U, 300U}) {
      const RasterFileShape shape{500, 400, 3};
      RasterFile file(path(format == RasterFileFormat::exr_half ? "left.exr" : "left.png"), shape, format);
      if (rows > 0) file.append(values({shape.width, rows, shape.channels}));
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Small files are only written as they are closed, which the library's own writers do not look at.
TEST_F(RasterFileTest, AFullDiskIsAnErrorHoweverSmallTheFile) {
  for (const auto& [name, format] :
       {std::pair{"full.png", RasterFileFormat::png8}, std::pair{"deep.png", RasterFileFormat::png16},
        std::pair{"full.exr", RasterFileFormat::exr_half}}) {
    fs::create_symlink("/dev/full", path(name));
    try {
      RasterFile file(path(name), {4, 4, 1}, format);
      file.append(values({4, 4, 1}));
      file.close();
      ADD_FAILURE() << "no error: " << name;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace shatterpave::relief
