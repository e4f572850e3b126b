// Every key of the scene file has an effect somewhere, and where one that is given has none, it is told.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "pipeline/key_outcomes.h"
#include "scene/keys.h"

namespace shatterpave::pipeline {
namespace {

namespace fs = std::filesystem;

class PlannedScenes : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "planned-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder = pattern;
    std::string plan_b = plan_a;
    for (std::size_t at = plan_b.find("0.3"); at != std::string::npos; at = plan_b.find("0.3", at + 1)) plan_b[at + 2] = '2';
    for (std::size_t at = plan_b.find("1.5"); at != std::string::npos; at = plan_b.find("1.5", at + 1)) plan_b[at + 2] = '4';
    std::ofstream(folder / "a.geojson") << plan_a;
    std::ofstream(folder / "b.geojson") << plan_b;
    std::ofstream(folder / "a.svg") << drawing;
  }
  void TearDown() override { fs::remove_all(folder); }

  fs::path folder;
};

TEST_F(PlannedScenes, EveryKeyOfPlansAndOfTheSceneHasAnEffect) {
  for (const PlacedChange& placed : placed_changes) {
    const KeyOutcome result = outcome(placed.rest, {"", {}}, placed.change, folder / "keys.toml");
    EXPECT_TRUE(result.has_effect) << placed.change.key << (result.refused ? " is refused" : " changes nothing");
    EXPECT_EQ(result.told, "") << placed.change.key;
  }
}

TEST_F(PlannedScenes, KeysWithoutAPlanOrAPaneAreTold) {
  const auto told = [&](const std::string& text, const std::string& set) {
    const scene::Scene scene = scene_with(text, {set}, folder / "keys.toml");
    return told_of(scene, set.substr(0, set.find('=')));
  };
  EXPECT_EQ(told(one_pavement, "still.dispersion=true"), "has no effect without a pane");
  EXPECT_EQ(told(one_pavement, "still.caustics=true"), "has no effect without a pane");
  EXPECT_EQ(told(yard, "plan.svg_scale=2"), "has no effect without a plan in SVG");
  EXPECT_EQ(told(one_pavement, "plan.origin=[1, 2]"), "has no effect without a plan in GeoJSON");
  EXPECT_EQ(told("[[pavement]]\nname = \"p\"\noutline_file = \"a.svg\"\n", "plan.origin=[1, 2]"),
            "has no effect without a plan in GeoJSON");
  for (const std::string key : {"guides_file=a.geojson", "guides_feature=path", "guides_class=walk"}) {
    EXPECT_EQ(told(yard, "pavement[0].direction." + key), "has no effect without kind = \"guides\"") << key;
  }
  EXPECT_EQ(told(one_pane + "[[pane.impact]]\nat_mm = [20, 20]\n", "pane[0].glass=tempered"), "");
  const scene::Scene twice =
      scene_with(one_pane + "[[pane.impact]]\nat_mm = [20, 20]\n", {"pane[0].glass=tempered"}, "keys.toml");
  EXPECT_EQ(told_of(twice, "pane[0].impact[1]"), "has no effect on tempered glass, which breaks at its first impact");
}

// So that a new key is tried too: each is a table of its own, or among the changes above.
TEST(SceneKeys, AreAllTried) {
  std::set<std::string> tried;
  const auto add = [&](std::string key) {
    for (std::size_t at = key.find("[0]"); at != std::string::npos; at = key.find("[0]")) key.replace(at, 3, "[]");
    tried.insert(key);
  };
  for (const Change& change : pane_changes) add(change.key);
  for (const Change& change : pavement_changes) add(change.key);
  for (const PlacedChange& placed : placed_changes) add(placed.change.key);
  for (const scene::KeyTable& table : scene::key_tables) {
    add(std::string(table.path));
    if (table.path.ends_with("[]")) add(std::string(table.path.substr(0, table.path.size() - 2)));
  }
  for (const scene::KeyTable& table : scene::key_tables) {
    for (const std::string_view key : table.keys) {
      const std::string path = std::string(table.path) + (table.path.empty() ? "" : ".") + std::string(key);
      EXPECT_TRUE(tried.contains(path)) << path;
    }
  }
}

}  // namespace
}  // namespace shatterpave::pipeline
