// What glass does with light, measured in pictures of bare slabs.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "core/embedded.h"
#include "core/vec.h"
#include "render/povray.h"

namespace shatterpave::render_tests {
namespace {

using Colour = std::array<double, 3>;

// The mean of a small picture of `scene`, which may include the materials of glass.
Colour mean_of(const std::string& name, const std::string& scene) {
  const std::filesystem::path folder = output_folder() / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  for (const std::string file : {"shatterpave_glass.inc", "shatterpave_shards.inc", "shatterpave_dirt.inc"}) {
    std::ofstream(folder / file) << embedded_text(file);
  }
  std::ofstream(folder / "scene.pov")
      << "#version 3.7;\n#include \"shatterpave_glass.inc\"\n#include "
         "\"shatterpave_shards.inc\"\n#include \"shatterpave_dirt.inc\"\nglobal_settings { assumed_gamma 1 "
         "max_trace_level 16 }\n"
      << scene;
  const relief::Raster picture = rendered(folder, "scene.pov", 8, 8);
  Colour mean{};
  for (std::size_t i = 0; i < picture.values.size(); ++i) mean.at(i % 3) += static_cast<double>(picture.values[i]);
  for (double& channel : mean) channel /= 64.0;
  return mean;
}

// A pane of 100 × 100 × 6 mm before a white sky, and rays through it: through its faces, or from edge to edge.
Colour through(const std::string& name, const std::string& material, bool along) {
  std::ostringstream scene;
  scene << "sky_sphere { pigment { rgb 1 } }\nbox { <-50, -50, -3>, <50, 50, 3> " << material
        << " }\ncamera { orthographic location " << (along ? "<-200, 0, 0>" : "<0, 0, -200>")
        << " look_at 0 right x * 2 up y * 2 }\n";
  return mean_of(name, scene.str());
}

TEST(GlassLook, EdgesAreGreenAndFacesNearlyClear) {
  const std::string shard = "texture { Shatterpave_Shard_Old } interior { Shatterpave_Shard_Interior }";
  for (const auto& [name, material] :
       {std::pair<std::string, std::string>{"glass_slab", "material { Shatterpave_Glass }"}, {"glass_shard", shard}}) {
    const Colour face = through(name + "_face", material, false);
    const Colour edge = through(name + "_edge", material, true);
    // Through 6 mm the two faces' reflections, which show the same sky, are all that is seen of the glass.
    EXPECT_GT(face[0], 0.9) << name;
    EXPECT_LT(face[1] / face[0], 1.08) << name;
    EXPECT_GE(face[1], face[0]) << name;
    // Along the pane light goes 100 mm: green is left, red most of all is gone, nothing is black.
    EXPECT_GT(edge[1] / edge[0], 1.3) << name;
    EXPECT_GT(edge[1] / edge[2], 1.05) << name;
    EXPECT_GT(edge[1], 0.5) << name;
  }
  // The twin: glass that takes nothing.
  const Colour clear = through("glass_clear_edge", "texture { Shatterpave_Shard_Old } interior { ior 1.52 }", true);
  EXPECT_NEAR(clear[1] / clear[0], 1.0, 0.01);
}

// Of a ray at that cosine from air into glass, both polarisations alike.
double fresnel(double cosine, double ior) {
  const double inside = std::sqrt(1.0 - (1.0 - cosine * cosine) / (ior * ior));
  const double s = (cosine - ior * inside) / (cosine + ior * inside);
  const double p = (ior * cosine - inside) / (ior * cosine + inside);
  return 0.5 * (s * s + p * p);
}

// White behind the viewer, black behind the glass: what is seen is what the pane reflects.
double reflected(const std::string& name, const std::string& material, double degrees) {
  const double angle = degrees * 3.14159265358979 / 180.0;
  std::ostringstream scene;
  scene << "sky_sphere { pigment { function { select(z, 1, 0) } color_map { [0 rgb 0] [1 rgb 1] } } }\n"
        << "box { <-5000, -5000, -3>, <5000, 5000, 3> " << material << " }\ncamera { orthographic location <"
        << -400.0 * std::sin(angle) << ", 0, " << -400.0 * std::cos(angle) << "> look_at 0 right x * 2 up y * 2 }\n";
  return mean_of(name, scene.str())[1];
}

// A pane has two faces, and between them light goes to and fro: with r of one, 2 r / (1 + r) in all.
TEST(GlassLook, PanesReflectAsFresnelSays) {
  for (const double degrees : {5.0, 45.0, 60.0, 75.0}) {
    const double r = fresnel(std::cos(degrees * 3.14159265358979 / 180.0), 1.52);
    const double expected = 2.0 * r / (1.0 + r);
    const std::string name = "glass_reflects_" + std::to_string(static_cast<int>(degrees));
    EXPECT_NEAR(reflected(name, "material { Shatterpave_Glass }", degrees), expected, 0.12 * expected + 0.003) << degrees;
  }
  // The twin: a mirror that is the same at all angles.
  const double flat = reflected(
      "glass_reflects_flat", "pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection 0.08 } interior { ior 1.52 }", 75.0);
  const double r = fresnel(std::cos(75.0 * 3.14159265358979 / 180.0), 1.52);
  EXPECT_LT(flat, 0.7 * 2.0 * r / (1.0 + r));
}

// What is seen of a wall behind a pane of 600 × 500 mm, on 60 × 60 mm about a place of it, with a light before it and one
// behind.
double behind(const std::string& name, double dirt, vec2 place, double wall) {
  std::ostringstream scene;
  scene << "light_source { <-3000, 3000, -6000> rgb 1 parallel point_at 0 }\n"
        << "light_source { <3000, 3000, 6000> rgb 1 parallel point_at 0 }\nsky_sphere { pigment { rgb " << wall << " } }\n"
        << "box { <0, 0, -2>, <600, 500, 2> texture { Shatterpave_Glass_Face } texture { pigment { function { " << dirt
        << " * Shatterpave_Dirt_On(x, y, z, 0, 0, 600, 500, 7) } color_map { Shatterpave_Dirt_Colours } } finish { "
           "Shatterpave_Dirt_Finish } } interior { ior 1.52 } double_illuminate }\n"
        << "camera { orthographic location <" << place.x << ", " << place.y << ", -200> direction z right x * 60 up y * 60 }\n";
  return mean_of(name, scene.str())[1];
}

TEST(GlassLook, DirtHidesWhatIsBehindAndLightsUp) {
  const vec2 middle{300.0, 250.0};
  const double clean_dark = behind("dirt_clean_dark", 0.0, middle, 0.02);
  const double clean_bright = behind("dirt_clean_bright", 0.0, middle, 2.0);
  double contrast = 1.0;
  for (const double dirt : {0.2, 0.5, 1.0}) {
    const std::string name = "dirt_" + std::to_string(static_cast<int>(100 * dirt));
    const double dark = behind(name + "_dark", dirt, middle, 0.02);
    const double bright = behind(name + "_bright", dirt, middle, 2.0);
    EXPECT_GT(dark, clean_dark + 0.04 * dirt) << dirt;
    EXPECT_LT(bright, clean_bright) << dirt;
    // What is seen through it: less with more dirt, but never nothing.
    const double left = (bright - dark) / (clean_bright - clean_dark);
    EXPECT_LT(left, contrast - 0.05) << dirt;
    EXPECT_GT(left, 0.3) << dirt;
    contrast = left;
  }
  EXPECT_LT(contrast, 0.75);
}

TEST(GlassLook, DirtGathersAlongTheFrame) {
  const double middle = behind("dirt_middle", 0.5, {300.0, 250.0}, 0.02);
  const double corner = behind("dirt_corner", 0.5, {32.0, 32.0}, 0.02);
  EXPECT_GT(corner, 1.15 * middle);
  EXPECT_LT(corner, 4.0 * middle);
  // Clean glass is the same everywhere.
  EXPECT_NEAR(behind("dirt_clean_corner", 0.0, {32.0, 32.0}, 0.02), behind("dirt_clean_middle", 0.0, {300.0, 250.0}, 0.02),
              1e-3);
}

// How bright an upright gap of 0.1 mm is in a slab of 6 mm before black, lit from both sides: the mean over 0.8 mm across it
// and 100 mm along it.
double gap_before_black(const std::string& name, const std::string& material, double degrees) {
  const double angle = degrees * 3.14159265358979 / 180.0;
  std::ostringstream scene;
  scene << "light_source { <-3000, 3000, -6000> rgb 1 parallel point_at 0 }\n"
        << "light_source { <3000, 3000, 6000> rgb 1 parallel point_at 0 }\nsky_sphere { pigment { rgb 0 } }\n"
        << "box { <-500, -500, -3>, <500, 500, 3> material { Shatterpave_Glass } }\n"
        << "box { <-0.05, -400, -2.99>, <0.05, 400, 2.99> " << material
        << " double_illuminate }\ncamera { orthographic location <" << 200.0 * std::sin(angle) << ", 0, "
        << -200.0 * std::cos(angle) << "> look_at 0 right x * 0.8 up y * 100 }\n";
  return mean_of(name, scene.str())[1];
}

// A crack is a line to who stands before it, also where it is upright and mirrors nothing, and in tempered glass more than in
// other. The twin: walls that are as dusty, and no more so along their mouths.
TEST(GlassLook, UprightGapsShow) {
  const std::string dusty =
      "texture { pigment { function { 0.04 } color_map { [0 rgb 0.95 transmit 1] [1 rgb 0.92 transmit 0] } } finish { ambient "
      "0 "
      "diffuse 0.8 specular 0.9 roughness 0.006 reflection { 0, 1 fresnel on } conserve_energy } } interior { ior 1 }";
  for (const double degrees : {0.0, 8.0}) {
    const std::string name = "gap_" + std::to_string(static_cast<int>(degrees));
    const double twin = gap_before_black(name + "_dusty", dusty, degrees);
    const double plain = gap_before_black(name + "_plain", "Shatterpave_Sheet(<-80, 0, 0>, 6, 0, 0)", degrees);
    const double dice = gap_before_black(name + "_dice", "Shatterpave_Sheet(<-80, 0, 0>, 6, 0, 1)", degrees);
    EXPECT_GT(plain, 1.5 * twin) << degrees;
    EXPECT_GT(dice, 1.25 * plain) << degrees;
    EXPECT_LT(dice, 0.3) << degrees;  // a line, and no bar
  }
}

}  // namespace
}  // namespace shatterpave::render_tests
