// What is said of a scene before anything is made of it.
#include "pipeline/outlook.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "export/targets.h"
#include "pipeline/generate.h"
#include "scene/read_scene.h"

namespace shatterpave::pipeline {
namespace {

std::string summary_of(const std::string& text) { return summary(scene::scene_of_text(text, "s.toml")); }

TEST(Summary, NamesThePanesAndPavements) {
  EXPECT_EQ(summary_of("[[pane]]\nname = \"w\"\npreset = \"agui1992-fig15a\"\n"), "1 pane (w, 300 × 300 mm, 1 impact)");
  EXPECT_EQ(summary_of("[[pavement]]\nname = \"p\"\nsize_mm = [1080, 1080]\nground.kerb_width_mm = 90\n"),
            "1 pavement (p, 1.2 m², about 110 stones, a kerb)");
}

TEST(Summary, CountsWhatIsTooMuchToName) {
  std::string text;
  for (int i = 0; i < 9; ++i) text += "[[pavement]]\nname = \"p" + std::to_string(i) + "\"\nsize_mm = [2160, 2160]\n";
  const std::string line = summary_of(text);
  EXPECT_TRUE(line.starts_with("9 pavements (p0, 4.7 m², about ")) << line;
  EXPECT_NE(line.find("; 6 more; in all 42.0 m², about "), std::string::npos) << line;
  EXPECT_EQ(line.find('\n'), std::string::npos);
}

// "About" is within 15 %, whatever the bond, of what is laid; of a plan with a bend and a hole.
class EstimatedStones : public testing::TestWithParam<std::string> {};

TEST_P(EstimatedStones, AreAboutThoseThatAreLaid) {
  const scene::Scene scene = scene::scene_of_text(
      "[[pavement]]\nname = \"p\"\noutline_mm = [[0, 0], [4000, 200], [4200, 3000], [2000, 2400], [100, 3100]]\n"
      "holes_mm = [[[1500, 1000], [2100, 1000], [2100, 1500]]]\n" +
          GetParam() + "\n",
      "s.toml");
  const auto laid = static_cast<double>(generated(scene).pavements.front().layout.stones.size());
  const std::string line = summary(scene);
  const double about = std::stod(line.substr(line.find("about ") + 6));
  EXPECT_LT(std::abs(about - laid), 0.15 * laid) << line << "; laid are " << laid;
}

INSTANTIATE_TEST_SUITE_P(Bonds, EstimatedStones,
                         testing::Values("bond = \"packed\"", "bond = \"running\"", "bond = \"stack\"",
                                         "bond = \"herringbone\"\nstone_preset = \"brick\"",
                                         "bond = \"basket_weave\"\nstone_preset = \"brick\"", "bond = \"hexagon\"",
                                         "bond = \"segmental_arc\"", "bond = \"fan\"", "bond = \"ashlar\"", "bond = \"crazy\"",
                                         "bond = \"chevron\"\nstone_mm = [240, 70]",
                                         "bond = \"running\"\ndirection.kind = \"boundary\"",
                                         "bond = \"running\"\nborder_course = \"soldier\"\nstone_mm = [200, 100]",
                                         "stone_mm = [50, 50]", "variation.missing = 0.5"));

// What is empty is told in the same words before and after.
TEST(Emptiness, IsToldOnceForEachThing) {
  const scene::Scene scene = scene::scene_of_text(
      "[[pane]]\nname = \"w\"\nsize_mm = [90, 70]\nimpact = [{at_mm = [40, 30], radial_count = 12}]\n"
      "shards.splinter_mm2 = 1000000\n"
      "[[pavement]]\nname = \"p\"\nsize_mm = [6, 6]\n[[pavement]]\nname = \"q\"\nsize_mm = [900, 900]\n",
      "s.toml");
  const std::vector<Note> before = emptiness(scene);
  ASSERT_EQ(before.size(), 1U);
  EXPECT_EQ(located(before[0]),
            "s.toml:6:1: pavement[0].stone_mm: note: no stone of p is laid: none fits in its 6 × 6 mm with joints of 8 mm");
  const std::vector<Note> after = emptiness(scene, generated(scene));
  ASSERT_EQ(after.size(), 2U);
  EXPECT_EQ(located(after[0]),
            "s.toml:5:1: pane[0].shards: note: leave nothing of w: every piece is missing or smaller than splinter_mm2");
  EXPECT_EQ(after[1], before[0]);
}

// A scene that was read from no file has names for places.
TEST(Emptiness, OfASceneWithoutAFileNamesTheThing) {
  scene::Scene scene;
  paving::Pavement pavement;
  pavement.name = "p";
  pavement.area.outline = {{0.0, 0.0}, {6.0, 0.0}, {6.0, 6.0}, {0.0, 6.0}};
  scene.pavements.push_back(pavement);
  const std::vector<Note> notes = emptiness(scene);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(located(notes[0]).starts_with("p.stone_mm: note: no stone of p is laid")) << located(notes[0]);
}

// Of meshes that were asked for, and of panes that are dirty.
TEST(Unseen, IsDirtOnMeshes) {
  const scene::Scene scene = scene::scene_of_text(
      "[[pane]]\nname = \"w\"\nsize_mm = [90, 70]\nimpact = [{at_mm = [40, 30]}]\n"
      "[[pane]]\nname = \"v\"\nsize_mm = [90, 70]\ndirt = 0.2\nimpact = [{at_mm = [40, 30]}]\n",
      "s.toml");
  const auto target = [](std::string_view name) {
    return *std::ranges::find(exporting::targets(), name, [](const exporting::Target* one) { return one->name; });
  };
  EXPECT_TRUE(unseen(scene, {target("povray"), target("json"), target("svg")}).empty());
  const std::vector<Note> notes = unseen(scene, {target("povray"), target("gltf"), target("ply")});
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(located(notes[0]), "s.toml:8:8: pane[1].dirt: note: has no effect on gltf, ply: dirt is a texture for POV-Ray");
}

}  // namespace
}  // namespace shatterpave::pipeline
