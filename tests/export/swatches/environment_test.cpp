#include "export/swatches/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "relief/out_of_focus.h"
#include "relief/panorama.h"

namespace shatterpave::exporting::swatches {
namespace {

shapes::Stage stage_with(Angle blur) {
  relief::Raster sky{32, 16, 3, std::vector<float>(32 * 16 * 3, 0.125F)};
  sky.values[(5 * 32 + 9) * 3] = 100.0F;
  Model model;
  model.name = "scene";
  model.light = studio::Light{};
  model.light->environment_blur = blur;
  model.environment = {"exr", std::make_shared<const std::string>(relief::encoded(sky, relief::RasterFormat::exr_half))};
  return shapes::stage_of(model);
}

TEST(Environment, InFocusIsTheVeryFileAndOnlyOnce) {
  const shapes::Stage stage = stage_with(Angle());
  Outputs outputs;
  append_environment(stage, outputs);
  append_environment(stage, outputs);
  ASSERT_EQ(outputs.files.size(), 1U);
  EXPECT_EQ(outputs.files[0].name, "scene_environment.exr");
  EXPECT_EQ(outputs.files[0].content, *stage.environment.content);
  EXPECT_EQ(seen_environment(stage), sharp_environment(stage));
}

TEST(Environment, OutOfFocusIsAnotherPictureOfTheSameLight) {
  const shapes::Stage stage = stage_with(Angle::degrees(20.0));
  Outputs outputs;
  append_environment(stage, outputs);
  ASSERT_EQ(outputs.files.size(), 1U);
  EXPECT_EQ(outputs.files[0].name, "scene_environment_blur20.exr");
  const relief::Raster read = relief::panorama(outputs.files[0].content, "exr");
  EXPECT_EQ(read.width, 216U);
  float brightest = 0.0F;
  for (const float value : read.values) brightest = std::max(brightest, value);
  // One pixel of 11.25° squared, at 28° above the horizon, over a disc of 20°.
  EXPECT_GT(brightest, 25.0F);
  EXPECT_LT(brightest, 45.0F);
}

}  // namespace
}  // namespace shatterpave::exporting::swatches
