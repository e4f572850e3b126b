// Shards in the files of other programs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/error.h"
#include "export/json/geometry_json.h"
#include "export/obj/shards_obj.h"
#include "export_panes.h"

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
  const nlohmann::json pane = nlohmann::json::parse(json_file(model).content)["panes"][0];
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
  const std::string apart = json_file(model).content;
  EXPECT_EQ(apart.find("joined"), std::string::npos);
  std::set<std::string> expected;
  for (const glass::Shard& shard : model.panes[0].shards) expected.insert(shard.id);
  model.panes = {support::shattered_pane(100, true)};
  std::set<std::string> ids;
  std::size_t bodies = 0;
  const nlohmann::json joined = nlohmann::json::parse(json_file(model).content);
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
  EXPECT_FALSE(nlohmann::json::parse(json_file(model).content)["panes"][0].contains("shards"));
}

// What a reader of OBJ makes of the text.
struct Read {
  std::vector<std::array<double, 3>> vertices;
  std::map<std::string, std::vector<std::array<std::size_t, 3>>> faces;  // by group
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
    if (word == "v") {
      auto& v = read.vertices.emplace_back();
      words >> v[0] >> v[1] >> v[2];
    } else if (word == "f") {
      auto& f = read.faces[group].emplace_back();
      words >> f[0] >> f[1] >> f[2];
    } else if (word == "g") {
      words >> group;
    } else if (word == "usemtl") {
      words >> word;
      read.materials.insert(word);
    }
  }
  return read;
}

class ShardsInObj : public testing::TestWithParam<bool> {};

TEST_P(ShardsInObj, EachShardIsAClosedGroupWhereItIs) {
  Model model = shattered_model();
  model.panes = {support::shattered_pane(100, GetParam())};
  const std::vector<OutputFile> files = obj_files(model);
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
    const auto group = read.faces.find("window." + shard.id);
    EXPECT_EQ(group != read.faces.end(), shard.state != glass::ShardState::missing) << shard.id;
    if (group == read.faces.end()) continue;
    ++there;
    std::set<std::pair<std::size_t, std::size_t>> edges;
    double lowest = 1e9;
    for (const auto& f : group->second) {
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(edges.insert({f[i], f[(i + 1) % 3]}).second);
        ASSERT_LE(f[i], read.vertices.size());
        lowest = std::min(lowest, read.vertices[f[i] - 1][1]);
      }
    }
    for (const auto& [a, b] : edges) EXPECT_TRUE(edges.contains({b, a})) << shard.id;
    EXPECT_EQ(lowest < -0.01, shard.state == glass::ShardState::fallen) << shard.id << ' ' << lowest;
  }
  EXPECT_EQ(there, read.faces.size());
}

INSTANTIATE_TEST_SUITE_P(Joined, ShardsInObj, testing::Bool());

TEST(ShardsObj, WantsShards) {
  Model model = shattered_model();
  model.panes[0].pane.shards.reset();
  EXPECT_THROW(obj_files(model), InputError);
}

}  // namespace
}  // namespace shatterpave::exporting
