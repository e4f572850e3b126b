// Shards in the files of other programs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/error.h"
#include "core/vec.h"
#include "export/export_panes.h"
#include "export/json/geometry_json.h"
#include "export/obj/shards_obj.h"
#include "geometry/solid.h"

namespace shatterpave::exporting {
namespace {

Model shattered_model() {
  Model model;
  model.name = "scene";
  model.panes = {support::shattered_pane(100)};
  return model;
}

TEST(ShardsJson, TellWhatEachShardIsAndWhereItIs) {
  const Model model = shattered_model();
  const nlohmann::json pane = nlohmann::json::parse(json::json_file(model).content)["panes"][0];
  ASSERT_EQ(pane["shards"].size(), model.panes[0].shards.size());
  std::map<std::string, int> states;
  std::set<std::string> ids;
  for (std::size_t i = 0; i < pane["shards"].size(); ++i) {
    const nlohmann::json& shard = pane["shards"][i];
    ++states[shard["state"]];
    ids.insert(shard["id"]);
    EXPECT_EQ(shard["outline_mm"].size(), model.panes[0].shards[i].face.outline.size());
    EXPECT_EQ(shard.contains("transform"), shard["state"] != "missing");
    if (shard["state"] == "standing") {
      EXPECT_EQ(shard["transform"], (nlohmann::json{1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0}));
    }
    if (shard["state"] == "fallen") {
      EXPECT_EQ(shard["transform"][7], model.panes[0].shards[i].motion.shift_mm.y) << shard["id"];
      EXPECT_NE(shard["transform"][11], 0.0) << shard["id"];
    }
  }
  EXPECT_EQ(ids.size(), pane["shards"].size());
  EXPECT_GT(states["standing"], 2);
  EXPECT_GT(states["fallen"], 2);
  EXPECT_GT(states["missing"], 2);
}

// A body lists its pieces; together with the rest these are the shards that there are without joining, and no other has a list.
TEST(ShardsJson, TellThePiecesOfJoinedBodies) {
  Model model = shattered_model();
  const std::string apart = json::json_file(model).content;
  EXPECT_EQ(apart.find("joined"), std::string::npos);
  std::set<std::string> expected;
  for (const glass::Shard& shard : model.panes[0].shards) expected.insert(shard.id);
  model.panes = {support::shattered_pane(100, true)};
  std::set<std::string> ids;
  std::size_t bodies = 0;
  const nlohmann::json joined = nlohmann::json::parse(json::json_file(model).content);
  for (const nlohmann::json& shard : joined["panes"][0]["shards"]) {
    if (!shard.contains("joined")) {
      EXPECT_TRUE(ids.insert(shard["id"]).second);
      continue;
    }
    ++bodies;
    EXPECT_EQ(shard["state"], "standing");
    EXPECT_GE(shard["joined"].size(), 2U);
    EXPECT_EQ(shard["joined"][0], shard["id"]);
    for (const nlohmann::json& id : shard["joined"]) EXPECT_TRUE(ids.insert(id).second);
  }
  EXPECT_GE(bodies, 1U);
  EXPECT_EQ(ids, expected);
}

TEST(ShardsJson, AreNotThereWhereNobodyAskedForThem) {
  Model model = shattered_model();
  model.panes[0].pane.shards.reset();
  EXPECT_FALSE(nlohmann::json::parse(json::json_file(model).content)["panes"][0].contains("shards"));
}

// What a reader of OBJ makes of the text.
struct Read {
  std::vector<vec3> vertices;
  std::vector<std::array<double, 2>> places;
  std::vector<vec3> normals;
  using Corner = std::array<std::size_t, 3>;                         // vertex, place, normal, from 0
  std::map<std::string, std::vector<std::array<Corner, 3>>> facets;  // by group
  std::set<std::string> materials;
};

Read read_obj(const std::string& text) {
  Read read;
  std::istringstream lines(text);
  std::string word;
  std::string group;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    words >> word;
    if (word == "v" || word == "vn") {
      vec3& v = (word == "v" ? read.vertices : read.normals).emplace_back(0.0, 0.0, 0.0);
      words >> v.x >> v.y >> v.z;
    } else if (word == "vt") {
      auto& v = read.places.emplace_back();
      words >> v[0] >> v[1];
    } else if (word == "f") {
      for (Read::Corner& corner : read.facets[group].emplace_back()) {
        char slash = ' ';
        words >> corner[0] >> slash >> corner[1] >> slash >> corner[2];
        for (std::size_t& number : corner) --number;
      }
      EXPECT_FALSE(words.fail()) << line;
    } else if (word == "g") {
      words >> group;
    } else if (word == "usemtl") {
      words >> word;
      read.materials.insert(word);
    }
  }
  return read;
}

vec3 across(const Read& read, const std::array<Read::Corner, 3>& facet) {
  const vec3 a = read.vertices.at(facet[0][0]);
  return glm::cross(read.vertices.at(facet[1][0]) - a, read.vertices.at(facet[2][0]) - a);
}

// Facets as a reader sees them who takes vertices in one place for one.
bool is_closed(const Read& read, const std::vector<std::array<Read::Corner, 3>>& facets) {
  std::map<std::array<double, 3>, std::size_t> places;
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (const auto& facet : facets) {
    std::array<std::size_t, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const vec3 p = read.vertices.at(facet[i][0]);
      corners[i] = places.try_emplace({p.x, p.y, p.z}, places.size()).first->second;
    }
    for (std::size_t i = 0; i < 3; ++i) ++edges[{corners[i], corners[(i + 1) % 3]}];
  }
  return std::ranges::all_of(edges, [&](const auto& edge) {
    const auto reverse = edges.find({edge.first.second, edge.first.first});
    return edge.second == 1 && reverse != edges.end() && reverse->second == 1;
  });
}

class ShardsInObj : public testing::TestWithParam<bool> {};

TEST_P(ShardsInObj, EachShardIsAClosedGroupWhereItIs) {
  Model model = shattered_model();
  model.panes = {support::shattered_pane(100, GetParam())};
  const std::vector<OutputFile> files = obj::obj_files(model);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].name, "scene.obj");
  EXPECT_EQ(files[1].name, "scene.mtl");
  EXPECT_NE(files[0].content.find("mtllib scene.mtl\n"), std::string::npos);
  const Read read = read_obj(files[0].content);
  EXPECT_EQ(read.materials, (std::set<std::string>{"glass_broken", "glass_old"}));
  for (const std::string& material : read.materials)
    EXPECT_NE(files[1].content.find("newmtl " + material + "\n"), std::string::npos);
  std::size_t there = 0;
  for (const glass::Shard& shard : model.panes[0].shards) {
    const auto group = read.facets.find("window." + shard.id);
    EXPECT_EQ(group != read.facets.end(), shard.state != glass::ShardState::missing) << shard.id;
    if (group == read.facets.end()) continue;
    ++there;
    EXPECT_TRUE(is_closed(read, group->second)) << shard.id;
    double lowest = 1e9;
    double volume = 0.0;
    for (const auto& facet : group->second) {
      volume += glm::dot(read.vertices[facet[0][0]], across(read, facet)) / 6.0;
      for (const Read::Corner& corner : facet) lowest = std::min(lowest, read.vertices[corner[0]].y);
    }
    EXPECT_NEAR(1e9 * volume, static_cast<double>(geometry::sextuple_volume(shard.solid)) / 6e9, 1e-3) << shard.id;
    EXPECT_EQ(lowest < -1e-5, shard.state == glass::ShardState::fallen) << shard.id << ' ' << lowest;
  }
  EXPECT_EQ(there, read.facets.size());
}

// Moved and then rounded to whole µm, some 2 of a thousand triangles had none.
TEST_P(ShardsInObj, EachTriangleHasAnAreaItsNormalAndAPlaceInTextures) {
  Model model = shattered_model();
  model.panes = {support::shattered_pane(100, GetParam())};
  const Read read = read_obj(obj::obj_files(model)[0].content);
  std::size_t count = 0;
  for (const auto& [group, facets] : read.facets) {
    for (const auto& facet : facets) {
      ++count;
      const vec3 twice = across(read, facet);
      ASSERT_GT(glm::length(twice), 1e-18) << group;
      const auto place = [&](std::size_t i) { return read.places.at(facet[i][1]); };
      const double u = (place(1)[0] - place(0)[0]) * (place(2)[1] - place(0)[1]);
      const double v = (place(1)[1] - place(0)[1]) * (place(2)[0] - place(0)[0]);
      // On the two axes that it faces most squarely at least 1 / √3 of it is left.
      EXPECT_GT(std::abs(u - v), 0.5 * glm::length(twice)) << group;
      for (const Read::Corner& corner : facet) {
        EXPECT_EQ(corner[2], facet[0][2]);
        EXPECT_NEAR(glm::dot(read.normals.at(corner[2]), glm::normalize(twice)), 1.0, 1e-5) << group;
      }
    }
  }
  EXPECT_GT(count, 5'000U);
}

INSTANTIATE_TEST_SUITE_P(Joined, ShardsInObj, testing::Bool());

TEST(ShardsObj, IsInMetresWithYUp) {
  Model model = shattered_model();
  std::erase_if(model.panes[0].shards, [](const glass::Shard& shard) { return shard.state == glass::ShardState::fallen; });
  const std::string text = obj::obj_files(model)[0].content;
  EXPECT_NE(text.find("1 unit = 1 m, y up"), std::string::npos);
  vec3 low{1e9, 1e9, 1e9};
  vec3 high = -low;
  for (const vec3 p : read_obj(text).vertices) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  // 300 × 300 × 2 mm
  EXPECT_TRUE(glm::length(low - vec3{0.0, 0.0, -0.001}) < 1e-6) << low.x << ' ' << low.y << ' ' << low.z;
  EXPECT_TRUE(glm::length(high - vec3{0.3, 0.3, 0.001}) < 1e-6) << high.x << ' ' << high.y << ' ' << high.z;
}

TEST(ShardsObj, MaterialsAreClearGlass) {
  const std::string text = obj::obj_files(shattered_model())[1].content;
  for (const char* line : {"Ka 0 0 0", "d 1", "Ni 1.52", "Tf 1 1 1", "Pm 0"}) {
    std::size_t count = 0;
    for (std::size_t at = text.find(fmt::format("\n{}\n", line)); at != std::string::npos;
         at = text.find(fmt::format("\n{}\n", line), at + 1)) {
      ++count;
    }
    EXPECT_EQ(count, 2U) << line;
  }
}

std::string refusal(const Model& model) {
  try {
    obj::obj_files(model);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(ShardsObj, IsRefusedWhereItWouldBeEmpty) {
  Model model = shattered_model();
  model.panes[0].pane.shards.reset();
  EXPECT_NE(refusal(model).find("expected a pane with a table [pane.shards]"), std::string::npos) << refusal(model);
  model.panes.clear();
  EXPECT_NE(refusal(model).find("got no pane"), std::string::npos) << refusal(model);
  model = shattered_model();
  for (glass::Shard& shard : model.panes[0].shards) shard.state = glass::ShardState::missing;
  EXPECT_NE(refusal(model).find("every piece of window is gone"), std::string::npos) << refusal(model);
  model.panes[0].shards.clear();
  EXPECT_NE(refusal(model).find("every piece of window is gone"), std::string::npos) << refusal(model);
}

}  // namespace
}  // namespace shatterpave::exporting
