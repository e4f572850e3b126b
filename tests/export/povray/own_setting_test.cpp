// The scene's own camera and light in POV-Ray, in the setting "own" and in those that have others of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

#include "core/embedded.h"
#include "export/export_panes.h"
#include "export/povray/povray.h"
#include "paving/laying.h"
#include "relief/raster.h"
#include "render/povray.h"

namespace shatterpave::exporting::povray {
namespace {

namespace fs = std::filesystem;

Model made_scene() {
  Model model;
  model.name = "own_scene";
  model.panes = {support::shattered_pane(12)};
  PavedArea paved;
  paved.pavement.name = "path";
  paved.pavement.area = {{{0, 0}, {400, 0}, {400, 300}, {0, 300}}, {}};
  paved.pavement.stone_mm = {90, 90};
  paved.pavement.relief.rms_mm = 0.0;  // else each file of the many takes a second
  paved.layout = paving::laid_stones(paved.pavement, 7);
  model.pavements = {paved};
  return model;
}

Model scene_of_both(const std::string& setting) {
  static const Model made = made_scene();
  Model model = made;
  model.setting = setting;
  return model;
}

// An environment of even grey with a colour in each direction: red in the north, green east, yellow south, blue west.
studio::Environment compass() {
  relief::Raster raster{64, 32, 3, std::vector<float>(64 * 32 * 3, 0.1F)};
  const auto paint = [&](std::size_t column, vec3 colour) {
    for (std::size_t y = 12; y < 20; ++y) {
      for (std::size_t x = column - 4; x < column + 4; ++x) {
        for (std::size_t c = 0; c < 3; ++c) raster.values[(y * 64 + x % 64) * 3 + c] = static_cast<float>(colour[c]);
      }
    }
  };
  paint(32, {1, 0, 0});
  paint(48, {0, 1, 0});
  paint(64, {1, 1, 0});
  paint(16, {0, 0, 1});
  return {"exr", std::make_shared<const std::string>(relief::encoded(raster, relief::RasterFormat::exr_half))};
}

relief::Raster picture(const Model& model, std::size_t width, std::size_t height) {
  const fs::path folder =
      render_tests::output_folder() / (std::string("own-") + testing::UnitTest::GetInstance()->current_test_info()->name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (const OutputFile& file : povray_files(model)) std::ofstream(folder / file.name, std::ios::binary) << file.content;
  return render_tests::rendered(folder, model.name + ".pov", width, height);
}

vec3 pixel(const relief::Raster& raster, std::size_t x, std::size_t y) {
  const float* value = &raster.values[(y * raster.width + x) * raster.channels];
  return {static_cast<double>(value[0]), static_cast<double>(value[1]), static_cast<double>(value[2])};
}

std::string text_of(const Model& model) { return povray_files(model).front().content; }

TEST(OwnSetting, OtherSettingsAreAsTheyWereWhereTheSceneHasNoCamera) {
  for (const std::string& setting : settings()) {
    if (setting == "own") continue;
    const std::string text = text_of(scene_of_both(setting));
    EXPECT_EQ(text.find("//@"), std::string::npos) << setting;
    EXPECT_EQ(text.find("Still_Camera"), std::string::npos) << setting;
    EXPECT_EQ(text.find("Still_Light"), std::string::npos) << setting;
    std::string pattern{embedded_text(setting + ".pov")};
    pattern = std::regex_replace(pattern, std::regex("//@(camera|light|end)[^\n]*\n"), "");
    EXPECT_EQ(text.substr(0, 400), pattern.substr(0, 400)) << setting;
    EXPECT_TRUE(text.ends_with(pattern.substr(pattern.find("//@model\n") + 9))) << setting;
  }
}

TEST(OwnSetting, EverySettingTakesTheScenesCameraAndLightInPlaceOfItsOwn) {
  for (const std::string& setting : settings()) {
    Model model = scene_of_both(setting);
    model.camera = studio::Camera{};
    model.light = studio::Light{};
    model.light->sun = studio::Sun{};
    const std::string text = text_of(model);
    const std::size_t camera = text.find("\nStill_Camera(");
    ASSERT_NE(camera, std::string::npos) << setting;
    EXPECT_NE(text.find("\nStill_Light("), std::string::npos) << setting;
    const auto count = [&](const std::string& pattern) {
      const std::regex expression(pattern);
      return std::distance(std::sregex_iterator(text.begin(), text.end(), expression), std::sregex_iterator());
    };
    EXPECT_EQ(count("camera \\{"), 1) << setting;
    EXPECT_EQ(count("sky_sphere \\{"), 1) << setting;
    EXPECT_EQ(count("\n(light_source|sky_sphere|background) \\{"), 0) << setting;
    EXPECT_EQ(count("\nSky_Light\\(|\n *Lamp_Light\\(<|\nSoft_Light\\("), 0) << setting;
  }
}

TEST(OwnSetting, LensAndSunAreThoseOfTheScene) {
  Model model = scene_of_both("own");
  model.camera = studio::Camera{};
  model.camera->at_mm = {0.0, -1000.0, 0.0};
  model.camera->field_of_view = Angle::radians(2.0 * std::atan(18.0 / 50.0));
  EXPECT_EQ(text_of(model).find("aperture"), std::string::npos);
  model.camera->focus_mm = 800.0;
  model.camera->f_number = 2.0;
  model.light = studio::Light{};
  const std::string text = text_of(model);
  // Four radii of a lens of 50 mm : 2.
  std::smatch found;
  ASSERT_TRUE(std::regex_search(text, found, std::regex("aperture ([0-9.]+)")));
  EXPECT_NEAR(std::stod(found[1]), 50.0, 1e-9);
  EXPECT_NE(text.find("focal_point vrotate(<0, 0, -200>, Turn) + Shift"), std::string::npos);
  EXPECT_EQ(text.find("area_light"), std::string::npos);
  model.light->sun = studio::Sun{Angle::degrees(90.0), Angle::degrees(0.0), 1.0};
  EXPECT_NE(text_of(model).find("   light_source {\n      <1, 0, 0> * 10000000, rgb <3, 3, 3>\n      area_light"),
            std::string::npos);
}

TEST(OwnSettingRender, SkyLiesAsTheWorldDoes) {
  Model model = scene_of_both("own");
  model.panes[0].pane.placement.at_mm = {0.0, 0.0, -90000.0};
  model.pavements.clear();
  model.environment = compass();
  model.light = studio::Light{};
  model.light->environment = "compass.exr";
  model.camera = studio::Camera{};
  model.camera->at_mm = {0.0, 0.0, 0.0};
  model.camera->look_at_mm = {0.0, 1000.0, 0.0};
  model.camera->field_of_view = Angle::degrees(150.0);
  // The colour in the middle and that of 60° to the right, where the north is turned to by −60°.
  const relief::Raster north = picture(model, 65, 9);
  EXPECT_GT(pixel(north, 32, 4).x, 0.9);
  EXPECT_LT(pixel(north, 32, 4).y, 0.05);
  model.light->environment_turn = Angle::degrees(-60.0);
  const relief::Raster turned = picture(model, 65, 9);
  const auto right = static_cast<std::size_t>(32.5 + 32.5 * std::tan(pi / 3.0) / std::tan(75.0 * pi / 180.0));
  EXPECT_GT(pixel(turned, right, 4).x, 0.9);
  EXPECT_LT(pixel(turned, 64 - right, 4).x, 0.3) << "the mirrored place";
  model.light->environment_turn = Angle();
  model.camera->look_at_mm = {1000.0, 0.0, 0.0};
  const relief::Raster east = picture(model, 65, 9);
  EXPECT_GT(pixel(east, 32, 4).y, 0.9);
  EXPECT_LT(pixel(east, 32, 4).x, 0.05);
  model.light->exposure_ev = 1.0;
  EXPECT_NEAR(pixel(picture(model, 65, 9), 32, 4).y, 2.0, 0.05);
}

// The focus may move over a shot: then each frame has its own picture, and shares what is in focus alone.
TEST(OwnSetting, FramesHaveASkyOfTheirOwnWhereItIsOutOfFocus) {
  Model model = scene_of_both("own");
  model.environment = compass();
  model.light = studio::Light{};
  model.light->environment = "compass.exr";
  const auto skies = [](const std::vector<OutputFile>& files) {
    return std::ranges::count_if(files, [](const OutputFile& file) { return file.name.find("_sky") != std::string::npos; });
  };
  const auto all = [](std::size_t) { return true; };
  EXPECT_EQ(skies(frame_files(model, all)), 0);
  EXPECT_EQ(skies(shared_files(model, all)), 1);
  model.light->environment_blur = Angle::degrees(3.0);
  EXPECT_EQ(skies(shared_files(model, all)), 0);
  const std::vector<OutputFile> frame = frame_files(model, all);
  ASSERT_EQ(skies(frame), 1);
  EXPECT_NE(frame.front().content.find("_sky_blur3.exr\""), std::string::npos);
}

double difference(const relief::Raster& a, const relief::Raster& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    sum += std::abs(static_cast<double>(a.values[i]) - static_cast<double>(b.values[i]));
  return sum / static_cast<double>(a.values.size());
}

TEST(OwnSettingRender, APaneThatIsTurnedLooksAsOneThatIsSeenFromTheOtherSide) {
  Model model = scene_of_both("own");
  model.pavements.clear();
  model.environment = compass();
  const auto seen = [&](double pane_turn, double world_turn) {
    const Angle turn = Angle::degrees(world_turn);
    model.panes[0].pane.placement.turn = Angle::degrees(pane_turn);
    model.camera = studio::Camera{};
    model.camera->at_mm = {rotated({150.0, -700.0}, turn), 260.0};
    model.camera->look_at_mm = {rotated({150.0, 0.0}, turn), 150.0};
    model.light = studio::Light{};
    model.light->environment = "compass.exr";
    model.light->environment_turn = turn;
    model.light->sun = studio::Sun{Angle::degrees(200.0 - world_turn), Angle::degrees(30.0), 1.0};
    return picture(model, 80, 60);
  };
  const relief::Raster turned = seen(40.0, 0.0);
  EXPECT_LT(difference(turned, seen(0.0, -40.0)), 0.004);
  EXPECT_GT(difference(turned, seen(0.0, 40.0)), 0.02) << "the wrong way round";
}

}  // namespace
}  // namespace shatterpave::exporting::povray
