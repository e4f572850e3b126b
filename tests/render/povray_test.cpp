#include "render/povray.h"

#include <gtest/gtest.h>

#include <fstream>

#include "render/comparison.h"

namespace shatterpave::render_tests {
namespace {

// A sphere of glass before a chequered floor, in the clearest form that shows refraction.
std::string sphere_on_floor(double ior) {
  return R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 1.5, -4> look_at <0, 0.7, 0> right x*4/3 }
light_source { <3, 5, -4> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { checker rgb 0.8 rgb 0.1 scale 0.5 } }
sphere { <0, 1, 0>, 1 pigment { rgbt 1 } interior { ior )" +
         std::to_string(ior) + " } }\n";
}

std::filesystem::path folder_with(const std::string& name, const std::string& scene) {
  std::filesystem::path folder = output_folder() / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "scene.pov") << scene;
  return folder;
}

TEST(RenderHarness, RepeatsToTheBit) {
  const auto folder = folder_with("harness_repeats", sphere_on_floor(1.5));
  const relief::Raster first = rendered(folder, "scene.pov", 80, 60);
  EXPECT_EQ(first.width, 80U);
  EXPECT_EQ(first.height, 60U);
  EXPECT_EQ(first, rendered(folder, "scene.pov", 80, 60));
}

TEST(RenderHarness, TellsGlassFromAir) {
  Case of;
  of.tolerances.fill({0.01, 0.0});
  const relief::Raster glass = rendered(folder_with("harness_glass", sphere_on_floor(1.5)), "scene.pov", 80, 60);
  const relief::Raster air = rendered(folder_with("harness_air", sphere_on_floor(1.0)), "scene.pov", 80, 60);
  EXPECT_FALSE(compared(of, glass, air).agrees());
}

TEST(RenderHarness, FailureAndWarningAreErrors) {
  const auto message_of = [](const std::string& name, const std::string& scene) {
    try {
      static_cast<void>(rendered(folder_with(name, scene), "scene.pov", 8, 6));
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message_of("harness_fails", "#version 3.7;\nsphere { nonsense }").find("nonsense"), std::string::npos);
  // Without a version POV-Ray warns and renders all the same.
  EXPECT_NE(message_of("harness_warns", "sphere { 0, 1 }").find("povray warned"), std::string::npos);
}

}  // namespace
}  // namespace shatterpave::render_tests
