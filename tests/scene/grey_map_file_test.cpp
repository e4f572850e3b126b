#include "scene/grey_map_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "scene/read_scene.h"

namespace shatterpave::scene {
namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;

class GreyMapFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("shatterpave-greys-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  GreyMapFile read(const std::string& content) const {
    std::ofstream(folder_ / "m.pgm", std::ios::binary) << content;
    return grey_map_of_file(folder_ / "m.pgm", Place{"s.toml", 7, 3, "map_file"});
  }
  std::string refusal(const std::string& content) const {
    try {
      static_cast<void>(read(content));
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  fs::path folder_;
};

TEST_F(GreyMapFiles, FiguresAndBytesSayTheSame) {
  const std::vector<float> greys = {0.0F, 0.2F, 0.4F, 0.6F, 0.8F, 1.0F};
  const GreyMapFile figures = read("P2 # by hand\n3 2\n# levels\n255\n0 51 102\n153 204 255\n");
  EXPECT_EQ(figures.columns, 3U);
  EXPECT_EQ(figures.greys, greys);
  const GreyMapFile bytes = read("P5\n3 2 255\n"s + "\0\x33\x66\x99\xcc\xff"s);
  EXPECT_EQ(bytes.greys, greys);
  EXPECT_NE(bytes.sum, figures.sum);
  EXPECT_EQ(read("P5 3 1 65535\n"s + "\0\0\x33\x33\xff\xff"s).greys, (std::vector<float>{0.0F, 0.2F, 1.0F}));
}

TEST_F(GreyMapFiles, FaultsAreToldByTheirPlace) {
  EXPECT_NE(refusal("P6 1 1 255\n   ").find("m.pgm: expected a portable greymap that begins with P2 or P5, got \"P6\""),
            std::string::npos)
      << refusal("P6 1 1 255\n   ");
  EXPECT_NE(refusal("").find("begins with P2 or P5"), std::string::npos);
  EXPECT_NE(refusal("P2").find("its width, 1 or more, got the end"), std::string::npos);
  EXPECT_NE(refusal("P2 0 4 255").find("1 to 16777216 pixels, got 0 x 4"), std::string::npos);
  EXPECT_NE(refusal("P5 5000 5000 255\n").find("16777216 pixels, got 5000 x 5000"), std::string::npos);
  EXPECT_NE(refusal("P5 99999999999 1 255\n").find("its width"), std::string::npos);
  EXPECT_NE(refusal("P2 2 1 0\n0 0").find("a greatest level from 1 to 65535, got 0"), std::string::npos);
  EXPECT_NE(refusal("P2 2 1 70000\n0 0").find("its greatest level"), std::string::npos);
  EXPECT_NE(refusal("P2 2 1 9\n0 10").find("levels up to 9, got 10"), std::string::npos);
  EXPECT_NE(refusal("P2 2 1 9\n0 x").find("a level for each pixel"), std::string::npos);
  EXPECT_NE(refusal("P2 2 2 9\n0 1").find("4 pixels, got fewer"), std::string::npos);
  EXPECT_NE(refusal("P5 2 2 255\nabc").find("4 bytes of pixels, got 3"), std::string::npos);
}

TEST_F(GreyMapFiles, AScenePutsItOverItsPlan) {
  std::ofstream(folder_ / "m.pgm") << "P2 2 1 1 0 1";
  const auto pavement_of = [&](const std::string& size) {
    std::ofstream(folder_ / "s.toml") << "[[pavement]]\nname = \"p\"\nsize_mm = [2000, 1000]\n[pavement.size]\n" + size;
    return scene_of_file(folder_ / "s.toml", {}).pavements.front();
  };
  const auto map = std::get<paving::SizesOfMap>(
      pavement_of("kind = \"map\"\nmap_file = \"m.pgm\"\ndark = 0.5\nlight = 2\nmap_area_mm = [[0, 0], [500, 400]]\n").sizes);
  EXPECT_EQ(map.dark, 0.5);
  EXPECT_EQ(map.light, 2.0);
  EXPECT_EQ(map.high_mm, (vec2{500, 400}));
  EXPECT_EQ(map.greys, (std::vector<float>{0.0F, 1.0F}));
  const auto whole = std::get<paving::SizesOfMap>(pavement_of("kind = \"map\"\nmap_file = \"m.pgm\"\n").sizes);
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
