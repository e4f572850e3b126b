// Layers of OpenUSD as text; what its readers say of them is tested by tests/scripts/usd_test.sh.
#include "export/usd/scene_usd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "core/error.h"
#include "core/parallel.h"
#include "export/export_panes.h"
#include "export/usd/material_text.h"
#include "export/usd/prim_text.h"
#include "export/usd/stage_text.h"
#include "export/usd/welded_mesh.h"
#include "paving/laying.h"

namespace shatterpave::exporting::usd {
namespace {

// Two facets of a square, each with its own points, the second turned away by its normals.
shapes::Piece creased_square() {
  shapes::Piece piece;
  piece.mesh.points_mm = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  piece.mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
  for (const vec3& p : piece.mesh.points_mm) piece.mesh.uv_m.emplace_back(p.x / 1000.0, p.y / 1000.0);
  piece.mesh.triangles = {0, 1, 2, 3, 4, 5};
  return piece;
}

TEST(UsdWeldedMesh, FacetsShareTheirPoints) {
  const WeldedMesh mesh = welded({creased_square()});
  const std::vector<std::array<std::int64_t, 3>> points = {{0, 0, 0}, {20000, 0, 0}, {20000, 20000, 0}, {0, 20000, 0}};
  EXPECT_EQ(mesh.points, points);
  EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  // Normals differ along the crease, places in textures do not.
  EXPECT_EQ(mesh.normals.values, (std::vector<std::array<std::int64_t, 3>>{{0, 0, 10000}, {0, 10000, 0}}));
  EXPECT_EQ(mesh.normals.of_corner, (std::vector<std::uint32_t>{0, 0, 0, 1, 1, 1}));
  EXPECT_TRUE(mesh.places.of_corner.empty());
  EXPECT_EQ(mesh.places.values, (std::vector<std::array<std::int64_t, 2>>{{0, 0}, {2000, 0}, {2000, 2000}, {0, 2000}}));
}

TEST(UsdWeldedMesh, CornersThatComeTogetherLeaveNoFacet) {
  shapes::Piece piece = creased_square();
  piece.mesh.points_mm[1] = {2.0, 1.99999, 0.0};
  const WeldedMesh mesh = welded({piece, creased_square()});
  EXPECT_EQ(mesh.facets_of_piece, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(mesh.corners.size(), 9U);
}

TEST(UsdText, NamesAreIdentifiers) {
  EXPECT_EQ(identifier("shop-window.2"), "shop_window_2");
  EXPECT_EQ(identifier("2 panes"), "_2_panes");
  EXPECT_EQ(identifier("Stra\xc3\x9f"
                       "e"),
            "Stra__e");
  EXPECT_EQ(identifier(""), "_");
}

TEST(UsdText, FilesMayBeCalledAnything) {
  EXPECT_EQ(asset("sky.exr"), "@./sky.exr@");
  EXPECT_EQ(asset("a@b.exr"), "@@@./a@b.exr@@@");
  EXPECT_EQ(asset("a@@@b.exr"), "@@@./a\\@@@b.exr@@@");
  EXPECT_EQ(in_usd_quotes("a \"b\""), "\"a \\\"b\\\"\"");
}

TEST(UsdText, NumbersAreShort) {
  EXPECT_EQ(vector_text({0.1230000004, -0.0, 2.0}, parts_of_m), "(0.123, 0, 2)");
  EXPECT_EQ(vector_text({0.00001, -1234.5678, 1.0 / 3.0}, parts_of_one), "(0, -1234.5678, 0.3333)");
}

std::string text_of(const shapes::Material& material, const SwatchFiles* swatch = nullptr) {
  Buffer out;
  PrimText text(out, 0);
  put_material(text, "/s", material, swatch);
  return fmt::to_string(out);
}

TEST(UsdMaterial, GlassLetsLightThrough) {
  const std::string glass = text_of({"glass_old", shapes::Substance::glass, {1.0F, 1.0F, 1.0F}, 0.0F});
  for (const char* line :
       {"token outputs:surface.connect = </s/glass_old/preview.outputs:surface>\n",
        "token outputs:mtlx:surface.connect = </s/glass_old/dielectric.outputs:out>\n", "float inputs:ior = 1.52\n",
        "float inputs:metallic = 0\n", "float inputs:opacity = 0.0426\n", "float inputs:base = 0\n",
        "float inputs:specular_IOR = 1.52\n", "float inputs:transmission = 1\n"}) {
    EXPECT_NE(glass.find(line), std::string::npos) << line << glass;
  }
  const std::string stone = text_of({"court_stone_3", shapes::Substance::stone, {0.25F, 0.2F, 0.1F}, 0.625F});
  EXPECT_NE(stone.find("color3f inputs:diffuseColor = (0.25, 0.2, 0.1)\n"), std::string::npos) << stone;
  EXPECT_NE(stone.find("float inputs:roughness = 0.625\n"), std::string::npos) << stone;
  EXPECT_EQ(stone.find("opacity"), std::string::npos);
  EXPECT_EQ(stone.find("mtlx"), std::string::npos);
}

TEST(UsdMaterial, StonesShowTheirSwatch) {
  shapes::Material stone{"court_stone_3", shapes::Substance::stone, {0.25F, 0.2F, 0.1F}, 0.625F};
  stone.swatch = shapes::SwatchUse{0, {0.5F, 0.25F, 1.0F}, 0.75F};
  const SwatchFiles files{"a.jpg", "n.jpg", "orm.jpg", 2.0};
  const std::string text = text_of(stone, &files);
  for (const char* line :
       {"color3f inputs:diffuseColor.connect = </s/court_stone_3/base_color.outputs:rgb>\n", "asset inputs:file = @./a.jpg@\n",
        "float4 inputs:scale = (0.5, 0.25, 1, 1)\n", "token inputs:sourceColorSpace = \"sRGB\"\n",
        "float4 inputs:bias = (-1, -1, -1, 0)\n", "float4 inputs:scale = (2, 2, 2, 1)\n",
        "float4 inputs:scale = (1, 0.75, 1, 1)\n", "float inputs:roughness.connect = </s/court_stone_3/surface.outputs:g>\n",
        "float2 inputs:scale = (0.5, 0.5)\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
}

std::string text_of(const shapes::Stage& stage) {
  Buffer out;
  PrimText text(out, 0);
  put_stage(text, stage);
  put_render_settings(text, stage, "/scene/camera");
  return fmt::to_string(out);
}

// 36 mm of film are 0.36 tenths of a metre; 50 mm lenses show 39.6 degrees.
TEST(UsdStage, CameraIsInTenthsOfMetres) {
  shapes::Stage stage;
  stage.camera.at_mm = {0.0, -3000.0, 0.0};
  stage.camera.field_of_view = Angle::degrees(90.0);
  stage.environment_name = "scene_environment.hdr";
  std::string text = text_of(stage);
  for (const char* line : {"float focalLength = 0.18\n", "float horizontalAperture = 0.36\n", "float verticalAperture = 0.27\n",
                           "float fStop = 0\n", "float focusDistance = 3\n", "quatf xformOp:orient = (1, 0, 0, 0)\n",
                           "double3 xformOp:translate = (0, 0, 3)\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
  EXPECT_EQ(text.find("Render"), std::string::npos);
  stage.camera.focus_mm = 2500.0;
  stage.camera.f_number = 4.0;
  stage.camera.size_px = {1920, 1080};
  text = text_of(stage);
  for (const char* line : {"float fStop = 4\n", "float focusDistance = 2.5\n", "float verticalAperture = 0.2025\n",
                           "uniform int2 resolution = (1920, 1080)\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
}

TEST(UsdStage, LightIsADomeAndASun) {
  shapes::Stage stage;
  stage.light.environment_gain = 2.0;
  stage.light.exposure_ev = -1.5;
  stage.environment_name = "scene_environment.hdr";
  std::string text = text_of(stage);
  EXPECT_EQ(text.find("DistantLight"), std::string::npos);
  for (const char* line :
       {"float inputs:intensity = 2\n", "float inputs:exposure = -1.5\n",
        "asset inputs:texture:file = @./scene_environment.hdr@\n", "quatf xformOp:orient = (0, 0, 1, 0)\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
  stage.light.sun = studio::Sun{};
  text = text_of(stage);
  EXPECT_NE(text.find("float inputs:angle = 0.53\n"), std::string::npos) << text;
}

Model model_of_both() {
  Model model;
  model.name = "2 things";
  model.seed = 5;
  model.panes = {support::shattered_pane(24)};
  model.panes[0].pane.name = "shop-window";
  paving::Pavement pavement;
  pavement.name = "court";
  pavement.area.outline = {{0.0, 0.0}, {2000.0, 0.0}, {2000.0, 1500.0}, {0.0, 1500.0}};
  pavement.stone_mm = {210.0, 100.0};
  pavement.bonding.bond = paving::Bond::running;
  pavement.surface.height_mm = 2.0;
  pavement.textures.swatch_px = 16;
  model.pavements = {{pavement, paving::laid_stones(pavement, 5)}};
  return model;
}

std::size_t count_of(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

TEST(Usd, HoldsAPrimForEachElement) {
  const Model model = model_of_both();
  const std::vector<OutputFile> files = usd_files(model);
  ASSERT_GE(files.size(), 1U);
  EXPECT_EQ(files[0].name, "2 things.usda");
  for (std::size_t i = 1; i < files.size(); ++i) {
    EXPECT_NE(files[0].content.find("asset inputs:file = @./" + files[i].name + "@\n"), std::string::npos) << files[i].name;
  }
  EXPECT_EQ(files.size(), 7U);  // three of stones, three of joints
  const std::string& text = files[0].content;
  EXPECT_TRUE(
      text.starts_with("#usda 1.0\n(\n    defaultPrim = \"_2_things\"\n    metersPerUnit = 1\n    upAxis = \"Y\"\n)\n"));
  EXPECT_EQ(count_of(text, "{"), count_of(text, "}"));
  EXPECT_NE(text.find("displayName = \"2 things\"\n"), std::string::npos);
  EXPECT_NE(text.find("displayName = \"shop-window\"\n"), std::string::npos);
  const auto there = std::ranges::count_if(model.panes[0].shards,
                                           [](const glass::Shard& shard) { return shard.state != glass::ShardState::missing; });
  EXPECT_EQ(count_of(text, "def Mesh \"shard_"), static_cast<std::size_t>(there));
  const std::size_t instances = count_of(text, "instanceable = true\n");
  EXPECT_GT(instances, 50U);
  EXPECT_EQ(count_of(text, "\"stone_"), model.pavements[0].layout.stones.size());
  EXPECT_EQ(count_of(text, "</_2_things/geometry/court/prototypes/shape_"), instances);
  std::set<std::string> shapes;
  for (std::size_t at = text.find("/prototypes/shape_"); at != std::string::npos;
       at = text.find("/prototypes/shape_", at + 1)) {
    shapes.insert(text.substr(at + 12, text.find('>', at) - at - 12));
  }
  for (const std::string& shape : shapes) EXPECT_NE(text.find("def Xform \"" + shape + "\" ("), std::string::npos) << shape;
}

TEST(Usd, IsRefusedWhereItWouldBeEmpty) {
  Model model;
  model.name = "scene";
  model.panes = {support::shattered_pane(24)};
  for (glass::Shard& shard : model.panes[0].shards) shard.state = glass::ShardState::missing;
  EXPECT_THROW(usd_files(model), InputError);
}

TEST(UsdInParallel, IsTheSameForAnyNumberOfThreads) {
  const Model model = model_of_both();
  const auto bytes = [&](int threads) {
    const ThreadLimit limit(threads);
    return usd_files(model)[0].content;
  };
  const std::string one = bytes(1);
  EXPECT_EQ(one, bytes(2));
  EXPECT_EQ(one, bytes(7));
}

}  // namespace
}  // namespace shatterpave::exporting::usd
