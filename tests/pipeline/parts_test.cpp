// Kerbs and steps of a scene: made once, named apart, and the same wherever a scene is judged or made.
#include "pipeline/parts.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "core/error.h"
#include "paving/limits.h"
#include "pipeline/generate.h"
#include "pipeline/measure.h"
#include "pipeline/outlook.h"
#include "scene/read_scene.h"

namespace shatterpave::pipeline {
namespace {

scene::Scene of_text(const std::string& text) { return scene::scene_of_text(text, "s.toml"); }

std::string table(const std::string& name, const std::string& lines) {
  return fmt::format("[[pavement]]\nname = \"{}\"\nsize_mm = [1000, 1000]\nstone_mm = [200, 100]\n{}\n", name, lines);
}

std::vector<std::string> names_of(const scene::Scene& scene) {
  std::vector<std::string> names;
  for (const PavementPart& part : pavement_parts(scene)) names.push_back(part.pavement.name);
  return names;
}

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string flight_lines = "bond = \"stack\"\nsteps.riser_mm = 160\nsteps.tread_mm = 400";

TEST(PavementParts, AreTheStepsOfAFlight) {
  const scene::Scene scene = of_text(table("p", flight_lines + "\nground.level_mm = 50"));
  ASSERT_EQ(scene.pavements.size(), 1U) << "a scene holds what is asked for";
  const std::vector<PavementPart> parts = pavement_parts(scene);
  EXPECT_EQ(names_of(scene), (std::vector<std::string>{"p", "p_2", "p_3"})) << "of a metre, the last one narrower";
  for (const PavementPart& part : parts) {
    EXPECT_EQ(part.asked, 0U);
    EXPECT_FALSE(part.is_kerb());
    EXPECT_FALSE(part.pavement.flight.has_value());
    EXPECT_EQ(part.pavement.bonding.bond, paving::Bond::stack);
    EXPECT_EQ(part.pavement.surface.height_mm, 160.0);
  }
  EXPECT_NEAR(parts[2].pavement.ground.level_mm - parts[0].pavement.ground.level_mm, 320.0, 1e-9);
}

TEST(PavementParts, AreNumberedThroughTheAreasOfATable) {
  scene::Scene scene = of_text(table("p", "ground.kerb_width_mm = 100") + table("q", flight_lines));
  scene.pavements.insert(scene.pavements.begin(), scene.pavements[0]);
  scene.pavements.push_back(scene.pavements.back());
  scene.pavement_places.clear();
  EXPECT_EQ(names_of(scene),
            (std::vector<std::string>{"p", "p_kerb", "p_2", "p_2_kerb", "q", "q_2", "q_3", "q_4", "q_5", "q_6"}));
  const std::vector<PavementPart> parts = pavement_parts(scene);
  EXPECT_TRUE(parts[3].is_kerb());
  EXPECT_EQ(parts[3].asked, 1U);
  EXPECT_EQ(parts[9].asked, 3U);
  // Without a file, names stand for places.
  scene.pavements[3].name = "p-kerb";
  EXPECT_EQ(refusal([&] { pavement_parts(scene); }), "p-kerb.name: expected a name of its own, got that of p");
}

// Wherever a scene is judged or made, the same words at the same place.
void expect_refused(const scene::Scene& scene, const std::string& message) {
  EXPECT_EQ(refusal([&] { pavement_parts(scene); }), message);
  EXPECT_EQ(refusal([&] { require_possible(scene); }), message);
  EXPECT_EQ(refusal([&] { summary(scene); }), message);
  EXPECT_EQ(refusal([&] { emptiness(scene); }), message);
  EXPECT_EQ(refusal([&] { generated(scene); }), message);
  EXPECT_EQ(refusal([&] { surveyed(scene, {}, {}); }), message);
}

TEST(PavementParts, HaveNamesOfTheirOwn) {
  const std::string other = "[[pavement]]\nname = \"path_2\"\nsize_mm = [9, 9]\n";
  expect_refused(of_text(table("path", flight_lines) + other),
                 "s.toml:9:8: pavement[1].name: expected a name of its own, got that of part 2 of pavement[0]");
  expect_refused(of_text(other + table("Path", flight_lines)),
                 "s.toml:5:8: pavement[1].name: expected a name of its own, got that of pavement[0]");
  expect_refused(of_text(table("path", "ground.kerb_width_mm = 9") + "[[pavement]]\nname = \"path-kerb\"\nsize_mm = [9, 9]\n"),
                 "s.toml:7:8: pavement[1].name: expected a name of its own, got that of pavement[0]");
  expect_refused(
      of_text("[[pane]]\nname = \"path_kerb\"\npreset = \"agui1992-fig15a\"\n" + table("path", "ground.kerb_width_mm = 9")),
      "s.toml:5:8: pavement[0].name: expected a name of its own, got that of pane[0]");
}

TEST(PavementParts, AreLimitedInNumber) {
  const auto flights = [](int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += table(fmt::format("p{}", i), "steps.tread_mm = 4");
    return of_text(all);
  };
  EXPECT_EQ(pavement_parts(flights(4)).size(), paving::most_pavements);
  EXPECT_EQ(refusal([&] { pavement_parts(flights(5)); }),
            "s.toml:21:1: pavement[4]: expected at most 1000 areas in all, got more");
}

// The texture of a kerb is of its whole area, since a strip about corners makes no tile: so what is checked is also made.
TEST(PavementParts, TakeAKerbBesideSeamlessTextures) {
  const scene::Scene scene = of_text(table("p", "bond = \"running\"\nground.kerb_width_mm = 100\ntextures.seamless = true"));
  require_possible(scene);
  const exporting::Model model = generated(scene);
  ASSERT_EQ(model.pavements.size(), 2U);
  EXPECT_TRUE(model.pavements[0].tile.has_value());
  EXPECT_FALSE(model.pavements[1].tile.has_value());
  EXPECT_FALSE(model.pavements[1].layout.stones.empty());
}

}  // namespace
}  // namespace shatterpave::pipeline
