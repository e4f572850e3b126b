#include <gtest/gtest.h>
#include <shatterpave/generate.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <utility>

#include "face/scenes.h"

namespace shatterpave {

namespace {

using Json = nlohmann::json;

Json parsed(const Model& model) { return Json::parse(json_of(model)); }

Json list_of(const std::vector<Point>& points) {
  Json list = Json::array();
  for (const Point& p : points) list.push_back({p.x, p.y});
  return list;
}

TEST(FaceModel, HoldsTheCracksOfTheFiles) {
  const Model model = generate(small_pane());
  const Pane& pane = model.panes().at(0);
  const Json json = parsed(model)["panes"][0];
  EXPECT_EQ(json["outline_mm"], list_of(pane.outline_mm));
  ASSERT_EQ(pane.impacts.size(), 1U);
  EXPECT_EQ(pane.impacts[0].radial_count, 12);
  EXPECT_EQ(json["impacts"][0]["large_count"], pane.impacts[0].large_count);
  ASSERT_EQ(pane.cracks.size(), json["cracks"].size());
  EXPECT_GT(pane.cracks.size(), 12U);
  for (std::size_t i = 0; i < pane.cracks.size(); ++i) {
    const Crack& crack = pane.cracks[i];
    const Json& line = json["cracks"][i];
    EXPECT_EQ(line["id"], crack.id);
    EXPECT_EQ(line["kind"], name_of(crack.kind));
    EXPECT_EQ(line["points_mm"], list_of(crack.points_mm));
    EXPECT_EQ(line["start"]["at"], name_of(crack.start.at));
    EXPECT_EQ(line["end"]["at"], name_of(crack.end.at));
    EXPECT_EQ(line["end"].value("crack", -1), crack.end.crack.value_or(-1));
  }
}

TEST(FaceModel, HoldsTheStonesOfTheFiles) {
  Scene scene = small_yard();
  scene.set("pavement.court.border_course", "soldier").set("pavement.court.ground.kerb_width_mm", 100);
  const Model model = generate(scene);
  const Json json = parsed(model)["pavements"];
  ASSERT_EQ(model.pavements().size(), 2U);
  std::map<StonePart, int> parts;
  for (std::size_t p = 0; p < 2; ++p) {
    const Pavement& pavement = model.pavements()[p];
    EXPECT_EQ(json[p]["name"], pavement.name);
    EXPECT_EQ(json[p]["outline_mm"], list_of(pavement.area_mm.outline));
    ASSERT_EQ(json[p]["stones"].size(), pavement.stones.size());
    for (std::size_t i = 0; i < pavement.stones.size(); ++i) {
      const Stone& stone = pavement.stones[i];
      const Json& line = json[p]["stones"][i];
      EXPECT_EQ(line["id"], stone.id);
      EXPECT_EQ(line["kind"], name_of(stone.kind));
      EXPECT_EQ(line["outline_mm"], list_of(stone.outline_mm));
      EXPECT_EQ(line["angle_deg"], stone.angle_deg);
      EXPECT_EQ(stone.part == StonePart::kerb, p == 1);
      EXPECT_GT(area(stone.outline_mm), 0.0);
      ++parts[stone.part];
    }
  }
  EXPECT_EQ(model.pavements()[1].name, "court_kerb");
  EXPECT_EQ(parts.size(), 3U);
  EXPECT_EQ(name_of(StonePart::border), "border");
}

TEST(FaceModel, OutlivesItsSceneAndIsSharedByCopies) {
  Model model = generate(small_yard());
  const Model copy = model;
  const std::vector<Pavement>* const pavements = &copy.pavements();
  model = generate(small_pane());
  EXPECT_EQ(&copy.pavements(), pavements);
  EXPECT_EQ(copy.name(), "yard");
  EXPECT_EQ(copy.seed(), 5U);
  EXPECT_TRUE(copy.panes().empty());
  EXPECT_EQ(model.panes().size(), 1U);
}

double sextuple(const Point3& a, const Point3& b, const Point3& c) {
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
}

TEST(FaceModelSlow, ShardsAreClosedSolidsOfGlassOldAndBroken) {
  Scene scene = small_pane();
  scene.set("pane.window.shards.enabled", true);
  const Model model = generate(scene);
  const Pane& pane = model.panes().at(0);
  ASSERT_GT(pane.shards.size(), 8U);
  double volume = 0.0;
  std::set<ShardState> states;
  for (std::size_t s = 0; s < pane.shards.size(); ++s) {
    const ShardMesh mesh = model.shard_mesh(0, s);
    states.insert(pane.shards[s].state);
    EXPECT_EQ(mesh.normals.size(), mesh.triangles.size());
    EXPECT_EQ(mesh.surfaces.size(), mesh.triangles.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    double part = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle& corners = mesh.triangles[t];
      for (std::size_t i = 0; i < 3; ++i) ++edges[{corners[i], corners[(i + 1) % 3]}];
      part += sextuple(mesh.vertices_mm[corners[0]], mesh.vertices_mm[corners[1]], mesh.vertices_mm[corners[2]]) / 6.0;
      const Point3& n = mesh.normals[t];
      EXPECT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1.0, 1e-12);
    }
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    for (const ShardSurface surface : {ShardSurface::old, ShardSurface::broken}) {
      EXPECT_NE(std::ranges::find(mesh.surfaces, surface), mesh.surfaces.end());
    }
    EXPECT_GT(part, 0.0);
    EXPECT_LE(part, area(pane.shards[s].face_mm) * pane.thickness_mm * (1.0 + 1e-9));
    volume += part;
  }
  EXPECT_NEAR(volume, area(pane.outline_mm) * pane.thickness_mm, 0.1 * area(pane.outline_mm) * pane.thickness_mm);
  EXPECT_GE(states.size(), 2U);
  EXPECT_THROW(model.shard_mesh(0, pane.shards.size()), std::out_of_range);
  EXPECT_THROW(model.shard_mesh(1, 0), std::out_of_range);
}

TEST(FaceModel, StonesAreSurfacesOverTheirOutlines) {
  Scene scene = small_yard();
  const Model model = generate(scene);
  const std::vector<Stone>& stones = model.pavements().at(0).stones;
  for (std::size_t s = 0; s < stones.size(); s += 7) {
    const StoneMesh mesh = model.stone_mesh(0, s, {.step_mm = 20.0});
    ASSERT_EQ(mesh.normals.size(), mesh.vertices_mm.size());
    double plan = 0.0;
    for (const Triangle& t : mesh.triangles) {
      Polygon flat;
      for (const std::uint32_t corner : t) flat.push_back({mesh.vertices_mm[corner].x, mesh.vertices_mm[corner].y});
      EXPECT_GE(area(flat), -1e-9);
      plan += area(flat);
    }
    EXPECT_NEAR(plan, area(stones[s].outline_mm), 0.02 * plan);
    for (const Point3& n : mesh.normals) EXPECT_GT(n.z, 0.0);
  }
  const StoneMesh rough = model.stone_mesh(0, 0, {.step_mm = 2.0});
  EXPECT_EQ(rough, model.stone_mesh(0, 0, {.step_mm = 2.0}));
  EXPECT_NE(rough, model.stone_mesh(0, 0, {.step_mm = 2.0, .relief = false}));
  EXPECT_GT(rough.triangles.size(), model.stone_mesh(0, 0).triangles.size());
  EXPECT_THROW(model.stone_mesh(0, stones.size()), std::out_of_range);
  EXPECT_THROW(model.stone_mesh(1, 0), std::out_of_range);
  for (const double step : {0.0, -1.0, std::nan(""), 1e9}) EXPECT_THROW(model.stone_mesh(0, 0, {.step_mm = step}), InputError);
}

TEST(FaceModel, StonesLieOnTheFallingGround) {
  Scene scene = small_yard();
  const StoneMesh level = generate(scene).stone_mesh(0, 3);
  scene.set("pavement.court.ground", Value::parsed("{fall_percent = 4, fall_deg = 0, level_mm = 30}"));
  const StoneMesh falling = generate(scene).stone_mesh(0, 3);
  ASSERT_EQ(falling.triangles, level.triangles);
  for (std::size_t i = 0; i < level.vertices_mm.size(); ++i) {
    const Point3& p = level.vertices_mm[i];
    EXPECT_NEAR(falling.vertices_mm[i].z, p.z + 30.0 - 0.04 * p.x, 1e-9);
    const Point3& n = level.normals[i];
    EXPECT_GT(falling.normals[i].x / falling.normals[i].z, n.x / n.z);
  }
}

TEST(FaceModel, NotesTellWhatIsEmpty) {
  Scene scene = small_yard();
  EXPECT_TRUE(generate(scene).notes().empty());
  scene.set("pavement.court.variation.missing", 1);
  ASSERT_EQ(generate(scene).notes().size(), 1U);
}

TEST(FaceGeometry, AreasAreThoseOfTheFormula) {
  const Polygon square = {{1e6, 1e6}, {1e6 + 2, 1e6}, {1e6 + 2, 1e6 + 2}, {1e6, 1e6 + 2}};
  EXPECT_EQ(area(square), 4.0);
  EXPECT_EQ(area(Polygon(square.rbegin(), square.rend())), -4.0);
  EXPECT_EQ(area(Polygon{}), 0.0);
  EXPECT_EQ(area(Region{square, {{{1e6, 1e6}, {1e6, 1e6 + 1}, {1e6 + 1, 1e6}}}}), 3.5);
  const Transform turn{{Point3{0, -1, 0}, Point3{1, 0, 0}, Point3{0, 0, 1}}, {10, 20, 30}};
  EXPECT_EQ(moved(turn, {1, 2, 3}), (Point3{8, 21, 33}));
}

}  // namespace

}  // namespace shatterpave
