// Scenes for Mitsuba as text and bytes; what Mitsuba itself makes of them is tested by tests/scripts/mitsuba_test.sh.
#include "export/mitsuba/scene_mitsuba.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <string>

#include "core/error.h"
#include "core/parallel.h"
#include "export/export_panes.h"
#include "export/mitsuba/mesh_file.h"
#include "export/mitsuba/xml.h"
#include "paving/laying.h"
#include "studio/world.h"

namespace shatterpave::exporting::mitsuba {
namespace {

TEST(MitsubaXml, ValuesMayHoldAnything) {
  Xml xml;
  xml.open("a", {{"name", "<\"&'>"}});
  xml.value("float", "x", number(-0.0));
  xml.close();
  EXPECT_EQ(xml.text(), "<a name=\"&lt;&quot;&amp;'&gt;\">\n  <float name=\"x\" value=\"0\"/>\n</a>\n");
  EXPECT_EQ(number(0.1), "0.1");
  EXPECT_EQ(numbers(vec3{1.5, -2.0, 1.0e-7}), "1.5, -2, 1e-07");
}

float float_at(const std::string& bytes, std::size_t at) {
  float value = 0.0F;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

TEST(MitsubaMesh, IsInMetresWithBodiesByNumber) {
  shapes::Mesh mesh;
  mesh.points_mm = {{0, 0, 0}, {1000, 0, 0}, {0, 500, 0}};
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  mesh.uv_m = {{0, 0}, {1, 0}, {0, 0.5}};
  mesh.triangles = {0, 1, 2};
  shapes::Body body;
  body.name = "window.3";
  body.kind = "shard fallen";
  MeshFile file;
  for (const std::uint32_t number : {4U, 5U}) {
    file.begin_body(number, body);
    file.add(mesh, {shapes::Placing{}.turn, {0, 0, 2000}});
  }
  const std::string bytes = file.taken();
  const std::string end = "end_header\n";
  const std::size_t start = bytes.find(end) + end.size();
  EXPECT_NE(bytes.find("comment body 5 window.3 shard fallen\nelement vertex 6\n"), std::string::npos);
  ASSERT_EQ(bytes.size(), start + 6 * 32 + 2 * 17);
  EXPECT_EQ(float_at(bytes, start + 32), 1.0F);       // x of the second point
  EXPECT_EQ(float_at(bytes, start + 32 + 8), 2.0F);   // z
  EXPECT_EQ(float_at(bytes, start + 32 + 20), 1.0F);  // its normal
  EXPECT_EQ(float_at(bytes, start + 6 * 32 + 13), 4.0F);
  EXPECT_EQ(float_at(bytes, start + 6 * 32 + 17 + 13), 5.0F);
  EXPECT_EQ(static_cast<int>(bytes[start + 6 * 32 + 17 + 1]), 3);  // corners go on from those of the first
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

Model model_of(std::vector<BrokenPane> panes) {
  Model model;
  model.name = "scene";
  model.panes = std::move(panes);
  return model;
}

Model bricks(double side_mm) {
  paving::Pavement pavement;
  pavement.name = "yard";
  pavement.area.outline = {{0, 0}, {side_mm, 0}, {side_mm, side_mm}, {0, side_mm}};
  pavement.stone_mm = {20, 10};
  pavement.joint_mm = 1;
  pavement.textures.swatch_px = 0;
  Model model;
  model.name = "scene";
  model.pavements = {{pavement, paving::laid_stones(pavement, 5)}};
  return model;
}

TEST(MitsubaScene, GlassBendsAndTakesLight) {
  const std::string xml = mitsuba_files(model_of({support::broken_pane(support::pane_with(12))}))[0].content;
  EXPECT_EQ(count(xml, "<integrator type=\"volpath\">"), 1U);
  EXPECT_EQ(count(xml, "<float name=\"int_ior\" value=\"1.52\"/>"), 2U);
  EXPECT_EQ(count(xml, "<medium type=\"homogeneous\" id=\"glass\">"), 1U);
  EXPECT_EQ(count(xml, "<ref name=\"interior\" id=\"glass\"/>"), 2U);  // slab and tubes
  EXPECT_EQ(count(xml, "thindielectric"), 0U);
  // Gaps are thinner than what rays step over.
  glass::Pane pane = support::pane_with(12);
  pane.crack_body = glass::CrackBody::sheet;
  const std::string gaps = mitsuba_files(model_of({support::broken_pane(pane)}))[0].content;
  EXPECT_EQ(count(gaps, "<bsdf type=\"thindielectric\" id=\"glass_film\">"), 1U);
  EXPECT_EQ(count(gaps, "<ref name=\"interior\" id=\"glass\"/>"), 1U);
  const std::string shards = mitsuba_files(model_of({support::shattered_pane(12)}))[0].content;
  EXPECT_EQ(count(shards, "<ref name=\"interior\" id=\"glass_of_shards\"/>"), 2U);
  EXPECT_EQ(count(shards, "thindielectric"), 0U);
}

TEST(MitsubaScene, ExposureIsInTheLights) {
  Model model = model_of({support::broken_pane(support::pane_with(6))});
  model.light = studio::Light{};
  model.light->environment_gain = 3.0;
  EXPECT_EQ(count(mitsuba_files(model)[0].content, "<float name=\"scale\" value=\"3\"/>"), 1U);
  model.light->exposure_ev = 1.0;
  const std::string xml = mitsuba_files(model)[0].content;
  EXPECT_EQ(count(xml, "<float name=\"scale\" value=\"6\"/>"), 1U);
  EXPECT_EQ(count(xml, "id=\"sun\""), 0U);
  model.light->sun = studio::Sun{};
  EXPECT_EQ(count(mitsuba_files(model)[0].content, "id=\"sun\""), 1U);
}

// Mitsuba has the middle of the picture at +z before it turns it about y.
TEST(MitsubaScene, EnvironmentStandsWhereTheWorldHasIt) {
  Model model = model_of({support::broken_pane(support::pane_with(6))});
  model.light = studio::Light{};
  const std::string before = "<rotate y=\"1\" angle=\"";
  for (const double turn_deg : {0.0, 30.0, -100.0, 275.0}) {
    model.light->environment_turn = Angle::degrees(turn_deg);
    const std::string xml = mitsuba_files(model)[0].content;
    const std::size_t at = xml.find(before);
    ASSERT_NE(at, std::string::npos);
    const vec2 turned = Angle::degrees(std::stod(xml.substr(at + before.size()))).direction();
    const vec3 middle = studio::upright_of_world(studio::direction_of({0.5, 0.5}, model.light->environment_turn));
    EXPECT_NEAR(turned.y, middle.x, 1e-6) << turn_deg;
    EXPECT_NEAR(turned.x, middle.z, 1e-6) << turn_deg;
  }
}

TEST(MitsubaScene, DepthOfFieldIsThatOfTheLens) {
  Model model = model_of({support::broken_pane(support::pane_with(6))});
  model.camera = studio::Camera{};
  EXPECT_EQ(count(mitsuba_files(model)[0].content, "<sensor type=\"perspective\""), 1U);
  model.camera->focus_mm = 1500.0;
  model.camera->f_number = 2.0;
  const std::string xml = mitsuba_files(model)[0].content;
  EXPECT_EQ(count(xml, "<sensor type=\"thinlens\""), 1U);
  EXPECT_EQ(count(xml, "<float name=\"focus_distance\" value=\"1.5\"/>"), 1U);
}

TEST(MitsubaScene, ManyStonesThatAreAlikeAreInstances) {
  const auto few = mitsuba_files(bricks(300));
  EXPECT_EQ(count(few[0].content, "instance"), 0U);
  EXPECT_EQ(count(few[0].content, "<integrator type=\"path\">"), 1U);
  const Model model = bricks(3500);
  ASSERT_GE(model.pavements[0].layout.stones.size(), 50000U);
  const auto many = mitsuba_files(model);
  EXPECT_GT(count(many[0].content, "type=\"instance\""), 40000U);
  EXPECT_LT(many.size(), 400U);
  std::set<std::string> names;
  for (const OutputFile& file : many) EXPECT_TRUE(names.insert(file.name).second) << file.name;
  const auto is_mesh = [](const OutputFile& file) { return file.name.ends_with(".ply"); };
  EXPECT_GT(std::ranges::count_if(many, is_mesh), 60);
  for (const OutputFile& file : many) {
    EXPECT_EQ(count(many[0].content, "\"" + file.name + "\""), is_mesh(file) ? 1U : 0U) << file.name;
  }
}

TEST(MitsubaScene, RefusesWhatIsGone) {
  BrokenPane broken = support::shattered_pane(6);
  for (glass::Shard& shard : broken.shards) shard.state = glass::ShardState::missing;
  EXPECT_THROW(mitsuba_files(model_of({broken})), InputError);
}

TEST(MitsubaInParallel, IsTheSameForAnyNumberOfThreads) {
  Model model = bricks(300);
  model.pavements[0].pavement.textures.swatch_px = 64;
  model.panes = {support::shattered_pane(24)};
  const auto bytes = [&](int threads) {
    const ThreadLimit limit(threads);
    std::string all;
    for (const OutputFile& file : mitsuba_files(model)) all += file.name + file.content;
    return all;
  };
  const std::string one = bytes(1);
  EXPECT_EQ(one, bytes(2));
  EXPECT_EQ(one, bytes(7));
}

}  // namespace
}  // namespace shatterpave::exporting::mitsuba
