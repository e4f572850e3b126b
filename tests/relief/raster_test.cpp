#include "relief/raster.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "relief/fractal_surface.h"

namespace shatterpave::relief {
namespace {

namespace fs = std::filesystem;

// A file that goes when the test does.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& bytes)
      : path_(fs::temp_directory_path() / ("shatterpave_" + std::to_string(getpid()) + "_" + name)) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~TemporaryFile() { fs::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

Raster gradient() {
  Raster raster{5, 3, 3, {}};
  for (int i = 0; i < 45; ++i) raster.values.push_back(static_cast<float>(i) / 64.0F);
  return raster;
}

TEST(Raster, IsReadBackAsWritten) {
  const Raster raster = gradient();
  // Sixty-fourths are exact in half and float.
  EXPECT_EQ(read_raster(TemporaryFile("h.exr", encoded(raster, RasterFormat::exr_half)).path()), raster);
  EXPECT_EQ(read_raster(TemporaryFile("f.exr", encoded(raster, RasterFormat::exr_float)).path()), raster);
  const auto expect_near = [&](const Raster& read, float tolerance) {
    ASSERT_EQ(read.values.size(), raster.values.size());
    for (std::size_t i = 0; i < read.values.size(); ++i) EXPECT_NEAR(read.values[i], raster.values[i], tolerance);
  };
  expect_near(read_raster(TemporaryFile("p.png", encoded(raster, RasterFormat::png16)).path()), 0.51F / 65535.0F);
  expect_near(read_raster(TemporaryFile("q.png", encoded(raster, RasterFormat::png8)).path()), 0.51F / 255.0F);
}

// The names of the chunks of a PNG file, in order.
std::string chunks(const std::string& png) {
  std::string names;
  for (std::size_t at = 8; at + 8 <= png.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = 256 * length + static_cast<unsigned char>(png[at + i]);
    const std::string name = png.substr(at + 4, 4);
    if (names.find(name) == std::string::npos) names += name + " ";
    at += length + 12;
  }
  return names;
}

TEST(Raster, FilesHoldNoTimeAndNoProgram) {
  EXPECT_EQ(chunks(encoded(gradient(), RasterFormat::png16)), "IHDR oFFs IDAT IEND ");
  const std::string exr = encoded(gradient(), RasterFormat::exr_half);
  const std::string empty_date("capDate\0string\0\0\0\0\0", 19);
  EXPECT_NE(exr.find(empty_date), std::string::npos);
  for (const char* word : {"Software", "software", "DateTime", "OpenImageIO", "hostComputer"}) {
    EXPECT_EQ(exr.find(word), std::string::npos) << word;
  }
}

TEST(Raster, FileThatIsNoImageIsAnInputErrorThatNamesIt) {
  const TemporaryFile file("no_image.png", "not a picture");
  try {
    read_raster(file.path());
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no_image.png"), std::string::npos) << error.what();
  }
  EXPECT_THROW(read_raster("/nowhere/at/all.png"), InputError);
}

TEST(Raster, DisplayIsTheCurveOfSrgb) {
  const Raster shown = display(Raster{2, 1, 4, {0.0F, 0.5F, 1.0F, 0.2F, -1.0F, 0.002F, 7.0F, 1.0F}});
  EXPECT_EQ(shown.channels, 3U);
  const std::vector<float> expected = {0.0F, 0.735357F, 1.0F, 0.0F, 0.02584F, 1.0F};  // IEC 61966-2-1
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(shown.values[i], expected[i], 1e-5F);
}

TEST(HeightImage, GivesTheHeightsBack) {
  const HeightField field = fractal_surface({32, 0.5, 0.6, 0.7, 8.0}, 7, Id("relief"));
  const HeightImage image = height_image(field);
  const Raster read = read_raster(TemporaryFile("relief.png", encoded(image.raster, RasterFormat::png16)).path());
  for (std::size_t i = 0; i < field.heights_mm.size(); ++i) {
    EXPECT_NEAR(image.low_mm + image.range_mm * static_cast<double>(read.values[i]), field.heights_mm[i],
                0.51 * image.range_mm / 65535.0);
  }
}

TEST(HeightImage, LevelFieldHasNoRange) {
  const HeightImage image = height_image(HeightField{2, 1, 1.0, {0.0, 0.0}});
  EXPECT_EQ(image.range_mm, 0.0);
  EXPECT_EQ(image.raster.values, (std::vector<float>{0.0F, 0.0F}));
}

}  // namespace
}  // namespace shatterpave::relief
