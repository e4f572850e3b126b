// glTF as JSON: textures of stones, glass as thick as its pane, and the same bytes everywhere.
#include "export/gltf/scene_gltf.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "core/parallel.h"
#include "export/export_panes.h"
#include "paving/laying.h"

namespace shatterpave::exporting::gltf {
namespace {

using Json = nlohmann::json;

Json json_of(const std::string& glb) {
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  return Json::parse(glb.substr(20, length));
}

paving::Pavement court(paving::Material material, std::uint16_t swatch_px) {
  paving::Pavement pavement;
  pavement.name = "court";
  pavement.area.outline = {{0.0, 0.0}, {2000.0, 0.0}, {2000.0, 1000.0}, {0.0, 1000.0}};
  pavement.stone_mm = {200.0, 100.0};
  pavement.bonding.bond = paving::Bond::running;
  pavement.surface.height_mm = 2.0;
  pavement.look.material = material;
  pavement.textures.swatch_px = swatch_px;
  return pavement;
}

Model paved(const std::vector<paving::Pavement>& pavements) {
  Model model;
  model.name = "scene";
  model.seed = 5;
  for (const paving::Pavement& pavement : pavements) model.pavements.push_back({pavement, paving::laid_stones(pavement, 5)});
  return model;
}

TEST(Gltf, StonesShowASwatchOfTheirMaterial) {
  const Json json = json_of(gltf_files(paved({court(paving::Material::brick, 128)}))[0].content);
  ASSERT_EQ(json["images"].size(), 6U);  // of bricks, and of joints
  std::set<std::string> names;
  for (const Json& image : json["images"]) {
    names.insert(image["name"]);
    EXPECT_EQ(image["mimeType"], "image/jpeg");
    EXPECT_FALSE(json["bufferViews"][image["bufferView"].get<std::size_t>()].contains("target"));
  }
  EXPECT_TRUE(names.contains("brick_BaseColor") && names.contains("sand_Normal"));
  std::set<std::string> tints;
  for (const Json& material : json["materials"]) {
    const Json& pbr = material["pbrMetallicRoughness"];
    EXPECT_EQ(pbr["metallicFactor"], 0.0);
    EXPECT_EQ(pbr["metallicRoughnessTexture"]["index"], material["occlusionTexture"]["index"]);
    EXPECT_TRUE(material.contains("normalTexture") && pbr.contains("baseColorTexture"));
    tints.insert(pbr["baseColorFactor"].dump());
  }
  EXPECT_GT(tints.size(), 10U);  // tones
  for (const Json& mesh : json["meshes"]) EXPECT_TRUE(mesh["primitives"][0]["attributes"].contains("TANGENT"));
}

TEST(Gltf, StonesHaveColoursAloneWhereThatIsAsked) {
  const Json json = json_of(gltf_files(paved({court(paving::Material::brick, 0)}))[0].content);
  EXPECT_FALSE(json.contains("images") || json.contains("textures") || json.contains("samplers"));
  for (const Json& material : json["materials"]) {
    EXPECT_FALSE(material.contains("normalTexture"));
    EXPECT_LT(material["pbrMetallicRoughness"]["baseColorFactor"][1], 0.3);
  }
}

TEST(Gltf, PavementsThatLookAlikeShareASwatch) {
  paving::Pavement other = court(paving::Material::brick, 64);
  other.name = "other";
  EXPECT_EQ(json_of(gltf_files(paved({court(paving::Material::brick, 64), other}))[0].content)["images"].size(), 6U);
  other.look.material = paving::Material::granite;
  EXPECT_EQ(json_of(gltf_files(paved({court(paving::Material::brick, 64), other}))[0].content)["images"].size(), 9U);
  // A name of its own, where the material is the same and the look is not.
  other.look.material = paving::Material::brick;
  other.look.wetness = 0.5;
  const Json json = json_of(gltf_files(paved({court(paving::Material::brick, 64), other}))[0].content);
  std::set<std::string> names;
  for (const Json& image : json["images"]) names.insert(image["name"]);
  EXPECT_EQ(names.size(), 12U);
}

// Twice the side of the swatch is twice the metres in 1.
TEST(Gltf, PlacesInTexturesAreSidesOfTheSwatch) {
  const auto extent = [&](vec2 stone_mm) {
    paving::Pavement pavement = court(paving::Material::granite, 64);
    pavement.stone_mm = stone_mm;
    const Model model = paved({pavement});
    const std::string glb = gltf_files(model)[0].content;
    const Json json = json_of(glb);
    std::uint32_t length = 0;
    std::memcpy(&length, glb.data() + 12, 4);
    // The texture coordinates of the first stone that is whole.
    for (const Json& node : json["nodes"]) {
      if (!node.contains("extras") || node["extras"]["kind"] != "stone whole") continue;
      const Json& primitive = json["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0];
      const Json& accessor = json["accessors"][primitive["attributes"]["TEXCOORD_0"].get<std::size_t>()];
      const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
      const char* data = glb.data() + 28 + length + view["byteOffset"].get<std::size_t>();
      float low = 1e9F;
      float high = -1e9F;
      for (std::size_t i = 0; i < accessor["count"]; ++i) {
        float u = 0.0F;
        std::memcpy(&u, data + 8 * i, 4);
        low = std::min(low, u);
        high = std::max(high, u);
      }
      return static_cast<double>(high - low);
    }
    return 0.0;
  };
  EXPECT_NEAR(extent({200.0, 100.0}), 0.2, 0.005);        // of a swatch of 1 m
  EXPECT_NEAR(extent({400.0, 300.0}), 0.4 / 2.0, 0.005);  // of one of 2 m
}

TEST(Gltf, GlassIsAsThickAsItsPane) {
  Model model;
  model.panes = {support::broken_pane(support::pane_with(8)), support::broken_pane(support::pane_with(8)),
                 support::broken_pane(support::pane_with(8))};
  model.panes[1].pane.name = "thick";
  model.panes[1].pane.thickness_mm = 6.0;
  model.panes[2].pane.name = "third";
  const Json json = json_of(gltf_files(model)[0].content);
  std::map<std::string, double> thickness;
  std::map<std::string, std::string> slab;
  for (const Json& material : json["materials"]) {
    thickness[material["name"]] = material["extensions"]["KHR_materials_volume"]["thicknessFactor"];
  }
  for (const Json& node : json["nodes"]) {
    const std::string name = node["name"];
    if (!name.ends_with(".slab")) continue;
    const Json& primitive = json["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0];
    slab[name] = json["materials"][primitive["material"].get<std::size_t>()]["name"];
  }
  EXPECT_EQ(slab["window.slab"], "glass_old");
  EXPECT_EQ(slab["thick.slab"], "glass_old_2");
  EXPECT_EQ(slab["third.slab"], "glass_old");
  EXPECT_DOUBLE_EQ(thickness["glass_old"], 0.002);
  EXPECT_DOUBLE_EQ(thickness["glass_old_2"], 0.006);
  EXPECT_DOUBLE_EQ(thickness["glass_broken_2"], 0.006);
}

// Puddles bend light as water does, and are taken to be a centimetre deep.
TEST(Gltf, WaterIsWater) {
  paving::Pavement pavement = court(paving::Material::brick, 0);
  pavement.look.wetness = 1.0;
  int found = 0;
  const Json json = json_of(gltf_files(paved({pavement}))[0].content);
  for (const Json& material : json["materials"]) {
    if (!material["name"].get<std::string>().ends_with("_water")) continue;
    ++found;
    EXPECT_DOUBLE_EQ(material["extensions"]["KHR_materials_ior"]["ior"], 1.333);
    EXPECT_DOUBLE_EQ(material["extensions"]["KHR_materials_volume"]["thicknessFactor"], 0.01);
    EXPECT_EQ(material["extensions"]["KHR_materials_transmission"]["transmissionFactor"], 1.0);
  }
  EXPECT_EQ(found, 1);
}

TEST(GltfInParallel, IsTheSameForAnyNumberOfThreads) {
  paving::Pavement pavement = court(paving::Material::granite, 128);
  pavement.bonding.bond = paving::Bond::fan;
  pavement.stone_mm = {100.0, 100.0};
  const Model model = paved({pavement});
  const auto bytes = [&](int threads) {
    const ThreadLimit limit(threads);
    return gltf_files(model)[0].content;
  };
  const std::string one = bytes(1);
  EXPECT_EQ(one, bytes(2));
  EXPECT_EQ(one, bytes(7));
}

}  // namespace
}  // namespace shatterpave::exporting::gltf
