#include "scene/direction_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "paving/bonds/bond.h"
#include "scene/read_scene.h"
#include "support/temporary_folder.h"

namespace shatterpave::scene {
namespace {

namespace fs = std::filesystem;

class DirectionFiles : public support::FolderTest {
 protected:
  DirectionFile read(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return direction_of_file(folder_ / name, Place{"s.toml", 7, 3, "grid_file"}, {});
  }
  std::string refusal(const std::string& name, const std::string& content) const {
    try {
      static_cast<void>(read(name, content));
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }
};

TEST_F(DirectionFiles, JsonAndCsvSayTheSame) {
  const auto json = read(
      "a.json", R"({"origin_mm": [10, 20], "pitch_mm": 500, "columns": 3, "vectors": [[1,0],[2,0],[0,0],[0,1],[0,-3],[1,1]]})");
  const auto csv =
      read("a.csv", "x_mm,y_mm,u,v\r\n10,20,1,0\n510,20,2,0\n1010,20,0,0\n1010,520,1,1\n510,520,0,-3\n10,520,0,1\n\n");
  EXPECT_EQ(json.grid.columns, 3U);
  EXPECT_EQ(json.grid.vectors.size(), 6U);
  EXPECT_EQ(csv.grid.vectors, json.grid.vectors);
  EXPECT_EQ(csv.grid.origin_mm, json.grid.origin_mm);
  EXPECT_NEAR(csv.grid.pitch_mm, 500.0, 1e-9);
  EXPECT_NE(csv.sum, json.sum);
  // As spreadsheets save it, with decimals that are rounded.
  const auto saved = read("b.csv",
                          "\xEF\xBB\xBFx_mm,y_mm,u,v\r\n0,0,1,0\r\n333.3333,0,1,0\r\n666.6667,0,1,0\r\n0,333.3333,1,0\r\n"
                          "333.3333,333.3333,1,0\r\n666.6667,333.3333,0,1\r\n");
  EXPECT_EQ(saved.grid.columns, 3U);
  EXPECT_EQ(saved.grid.vectors.back(), (vec2{0, 1}));
}

TEST_F(DirectionFiles, RefusesWhatIsNoField) {
  const auto says = [](const std::string& text, const char* words) { return text.find(words) != std::string::npos; };
  const std::string head = R"({"origin_mm": [0, 0], "pitch_mm": 500, "columns": 2, "vectors": )";
  EXPECT_TRUE(says(refusal("a.json", head + "[[1,0],[1,0],[1,0]]}"), "two or more whole rows of 2, got 3 vectors"));
  EXPECT_TRUE(says(refusal("a.json", head + "[[1,0],[1,0],[1,0],[1,\"x\"]]}"), "vectors[3]"));
  EXPECT_TRUE(says(refusal("a.json", head + "[[0,0],[0,0],[0,0],[0,0]]}"), "a vector other than [0, 0]"));
  EXPECT_TRUE(says(refusal("a.json", head + "[[1e300,0],[1,0],[1,0],[1,0]]}"), "vectors[0]"));
  EXPECT_TRUE(says(refusal("a.json", head), "expected JSON"));
  EXPECT_TRUE(says(refusal("a.json", "[1]"), "an object"));
  EXPECT_TRUE(says(refusal("a.csv", "x,y,u,v\n"), "a.csv:1:1"));
  EXPECT_TRUE(says(refusal("a.csv", "x_mm,y_mm,u,v\n0,0,1,0\n1,0,nan,0\n"), "a.csv:3:1"));
  EXPECT_TRUE(says(refusal("a.csv", "x_mm,y_mm,u,v\n0,0,1,0\n9,0,1,0\n0,9,1,0\n7,9,1,0\n"), "square grid"));
  // What is wrong is named, not a pitch that follows from it.
  const std::string square = "x_mm,y_mm,u,v\n0,0,1,0\n500,0,1,0\n0,500,1,0\n";
  EXPECT_TRUE(says(refusal("a.csv", square + "500,500,1,0\n500,500,0,1\n"),
                   "a.csv:6:1: expected each place of the grid once, got (500, 500) again"));
  EXPECT_TRUE(says(refusal("a.csv", "x_mm,y_mm,u,v\n0,0,1,0\n500,0,1,0\n0,300,1,0\n500,300,1,0\n"),
                   "expected a square grid, got places 500 mm apart along x and 300 mm along y"));
  EXPECT_TRUE(says(refusal("a.csv", "x_mm,y_mm,u,v\n7,0,1,0\n7,500,1,0\n7,1000,1,0\n7,1500,0,1\n"),
                   "expected two or more rows and columns, got vectors on a line"));
  EXPECT_TRUE(says(refusal("a.csv", "x_mm,y_mm,u,v\n0,7,1,0\n500,7,1,0\n1000,7,1,0\n1500,7,0,1\n"), "got vectors on a line"));
  EXPECT_TRUE(says(refusal("a.csv", square + "1000,0,1,0\n1000,500,1,0\n"),
                   "expected a vector at each of 3 x 2 places, 500 mm apart, got none at (500, 500)"));
  EXPECT_TRUE(says(refusal("a.csv", "x_mm,y_mm,u,v\n0,0,1,0\n9,0,1,0\n0,9,1,0\n0,9,1,0\n"), "a.csv:5:1"));
  EXPECT_TRUE(says(refusal("a.txt", ""), ".json, .csv or .exr"));
  const std::string with_unit = R"({"unit": "m", )" + head.substr(1) + "[[1,0],[1,0],[1,0],[1,0]]}";
  EXPECT_TRUE(
      says(refusal("a.json", with_unit), "expected the keys origin_mm, pitch_mm, columns, vectors alone, got \"unit\""));
}

TEST_F(DirectionFiles, PackedStonesFollowIt) {
  std::ofstream(folder_ / "f.csv") << "x_mm,y_mm,u,v\n0,0,1,1\n1000,0,1,1\n0,1000,-2,-2\n1000,1000,0,0\n";
  const std::string text =
      "[[pavement]]\nname = \"p\"\nsize_mm = [1000, 1000]\nstone_mm = [200, 100]\n[pavement.direction]\nkind = \"grid\"\n"
      "grid_file = \"f.csv\"\n";
  const Scene scene = scene_of_text(text, (folder_ / "s.toml").string());
  ASSERT_TRUE(std::holds_alternative<paving::GridDirection>(scene.pavements.front().direction));
  EXPECT_NEAR(paving::main_direction(scene.pavements.front()).degrees(), 45.0, 1e-9);
  EXPECT_THROW(
      scene_of_text(text.substr(0, text.find("[pavement.d")) + "bond = \"running\"\n" + text.substr(text.find("[pavement.d")),
                    (folder_ / "s.toml").string()),
      InputError);
}

}  // namespace
}  // namespace shatterpave::scene
