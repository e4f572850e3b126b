#include <gtest/gtest.h>
#include <shatterpave/generate.h>
#include <shatterpave/scene.h>

#include <cstdint>
#include <fstream>
#include <limits>
#include <utility>

#include "face/scenes.h"

namespace shatterpave {

namespace {

std::string json_of(const Scene& scene) { return json_of(generate(scene)); }

template <typename Work>
InputError refusal(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was refused";
  return InputError("");
}

TEST(FaceValue, IsTheTomlOfWhatItIsMadeFrom) {
  EXPECT_EQ(Value(true).toml(), "true");
  EXPECT_EQ(Value(7).toml(), "7");
  EXPECT_EQ(Value(std::uint64_t{9}).toml(), "9");
  EXPECT_EQ(Value(0.1).toml(), "0.1");
  EXPECT_EQ(Value(1.0 / 3.0).toml(), "0.3333333333333333");
  EXPECT_EQ(Value(-2.5F).toml(), "-2.5");
  EXPECT_EQ(Value("4").toml(), "\"4\"");
  EXPECT_EQ(Value("a\"b\\c\nd\x7f").toml(), "\"a\\\"b\\\\c\\u000Ad\\u007F\"");
  EXPECT_EQ(Value(Point{1, 2.5}).toml(), "[1, 2.5]");
  EXPECT_EQ(Value::parsed("[1, 2]").toml(), "[1, 2]");
}

TEST(FaceScene, ByKeysIsTheSceneOfAFileWithThem) {
  const Scene text = Scene::from_text(R"(
seed = 3
[[pane]]
name = "window"
outline_mm = [[0, 0], [300, 0], [300, 200], [0, 200]]
[[pane.impact]]
at_mm = [150, 100]
radial_count = 12
large_count = 9
circular_count = 4
[[pavement]]
name = "court"
size_mm = [900, 700]
holes_mm = [[[400, 300], [600, 500], [400, 500]]]
stone_mm = [200, 100]
[pavement.ground]
kerb_width_mm = 80
)");
  Scene keys = small_pane();
  keys.add_pavement("court", {{0, 0}, {900, 0}, {900, 700}, {0, 700}}, {{{400, 300}, {600, 500}, {400, 500}}});
  keys.set("pavement.court.stone_mm", Point{200, 100}).set("pavement[0].ground.kerb_width_mm", 80.0);
  EXPECT_EQ(json_of(keys), json_of(text));
  EXPECT_EQ(keys.name(), "pane");
  EXPECT_EQ(keys.seed(), 3U);
  EXPECT_EQ(keys.pane_names(), std::vector<std::string>{"window"});
  EXPECT_EQ(keys.pavement_names(), std::vector<std::string>{"court"});
}

TEST(FaceScene, ValuesMayBeAnyThatSetTakes) {
  Scene scene = small_pane();
  scene.set("pane.window.thickness_mm", Value::parsed("4"));
  scene.set("pane.window", Value::parsed("{name = \"door\", size_mm = [300, 200]}"));
  scene.set(scene.add("pane.door.impact") + ".at_mm", Point{100, 100});
  EXPECT_EQ(scene.pane_names(), std::vector<std::string>{"door"});
  // A text that looks like a number stays one, and is then no length.
  scene.set("pane.door.thickness_mm", "4");
  EXPECT_EQ(refusal([&] { scene.check(); }).place(), (Place{"set(\"pane.door.thickness_mm\")", 0, 0, "pane[0].thickness_mm"}));
}

TEST(FaceScene, ErrorsTellTheCallOrTheLine) {
  Scene scene = small_pane();
  const InputError unknown = refusal([&] { scene.set("pane.window.thicknes_mm", 4); });
  EXPECT_EQ(unknown.place(), (Place{"set(\"pane.window.thicknes_mm\")", 0, 0, "pane[0].thicknes_mm"}));
  EXPECT_NE(unknown.message().find("thickness_mm"), std::string::npos) << unknown.message();

  const Scene text = Scene::from_text("[[pane]]\nname = \"a\"\nsize_mm = [3, -1]\n", "/nowhere/a.toml");
  // A copy knows as well where its values stand.
  const Scene copy = text;
  EXPECT_EQ(refusal([&] { copy.check(); }).place(), (Place{"/nowhere/a.toml", 3, 15, "pane[0].size_mm[1]"}))
      << refusal([&] { copy.check(); }).what();
  EXPECT_EQ(refusal([] { Scene::from_text("a = [", "a.toml"); }).place().file, "a.toml");
  EXPECT_EQ(refusal([] { Scene::from_file("/nowhere/b.toml"); }).place().file, "/nowhere/b.toml");
  EXPECT_THROW(Scene().check(), InputError);
}

TEST(FaceScene, PathsThatLeadNowhereAreRefusedAndChangeNothing) {
  Scene scene = small_pane();
  const std::string before = json_of(scene);
  EXPECT_THROW(scene.set("pane.door.thickness_mm", 4), InputError);
  EXPECT_THROW(scene.set("pane[1].thickness_mm", 4), InputError);
  EXPECT_THROW(scene.set("still.made.here[0]", 4), InputError);  // after making two tables on the way
  EXPECT_THROW(scene.set("", 4), InputError);
  EXPECT_THROW(scene.set("pane[", 4), InputError);
  EXPECT_THROW(scene.set("seed.more", 4), InputError);
  EXPECT_THROW(scene.add("seed"), InputError);
  EXPECT_THROW(scene.add("pane.window"), InputError);
  EXPECT_THROW(scene.add("pane.window.outline_mm"), InputError);
  EXPECT_THROW(scene.add_impact("door", {1, 1}), InputError);
  EXPECT_THROW(scene.add_pane("\xff"), InputError);
  EXPECT_EQ(json_of(scene), before);
}

TEST(FaceScene, HostileTextsAreRefusedOrTaken) {
  for (const std::string name : {"", " ", "a/b", "a\"b", "a\nb", "\xff", "}", "{", "'''", "a#b"}) {
    Scene scene;
    try {
      scene.add_pane(name, {{0, 0}, {300, 0}, {300, 200}});
      scene.check();
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  for (const std::string name : {"", "a/b", "a\"b", "a\nb"}) EXPECT_THROW(Scene{name}, InputError) << name;
  EXPECT_EQ(Scene("my.scene").name(), "my.scene");
  const double wrong[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300};
  for (const double number : wrong) {
    Scene scene = small_pane();
    scene.set("pane.window.thickness_mm", number);
    EXPECT_THROW(scene.check(), InputError) << number;
    Scene other;
    other.add_pane("other", {{number, 0}, {1, 0}, {0, 1}});
    EXPECT_THROW(other.check(), InputError) << number;
  }
  Scene scene = small_pane();
  scene.set("seed", std::numeric_limits<std::uint64_t>::max());
  EXPECT_THROW(scene.check(), InputError);
}

TEST(FaceScene, CopiesAreIndependent) {
  Scene scene = small_pane();
  Scene trial = scene;
  trial.set("pane.window.thickness_mm", -1);
  EXPECT_THROW(trial.check(), InputError);
  scene.check();
  trial = scene;
  trial.check();
  Scene moved = std::move(trial);
  moved.check();
  trial = std::move(moved);
  EXPECT_EQ(trial.pane_names(), scene.pane_names());
}

TEST(FaceScene, CheckRefusesWhatCannotBeMade) {
  Scene scene = small_yard();
  scene.set("pavement.court.textures.seamless", true).set("pavement.court.bond", "crazy");

  EXPECT_THROW(scene.check(), InputError);
}

TEST(FaceScene, NotesTellKeysWithoutEffectAndWhatIsEmpty) {
  Scene scene = small_pane();
  EXPECT_TRUE(scene.notes().empty());
  scene.set("pane.window.impact[0].speed_m_s", 5);
  ASSERT_EQ(scene.notes().size(), 1U);
  EXPECT_EQ(scene.notes()[0].place.key, "pane[0].impact[0].speed_m_s");
  scene.add_pavement("narrow", {{0, 0}, {300, 0}, {300, 5}, {0, 5}});
  EXPECT_EQ(scene.notes().size(), 2U);
}

TEST(FaceScene, FilesLieBesideTheScene) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "face_scene";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "plan.svg")
      << R"(<svg xmlns="http://www.w3.org/2000/svg" width="500mm" height="400mm" viewBox="0 0 500 400">)"
      << R"(<rect id="a" width="500" height="400"/></svg>)";
  std::ofstream(folder / "yard.toml") << "[[pavement]]\nname = \"court\"\noutline_file = \"plan.svg\"\n";
  const Model model = generate(Scene::from_file(folder / "yard.toml"));
  EXPECT_EQ(area(model.pavements().at(0).area_mm), 200000.0);
  EXPECT_EQ(model.name(), "yard");
  std::filesystem::remove_all(folder);
}

}  // namespace

}  // namespace shatterpave
