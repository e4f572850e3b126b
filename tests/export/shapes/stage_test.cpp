#include "export/shapes/stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "export/export_panes.h"
#include "export/shapes/bodies.h"
#include "studio/world.h"

namespace shatterpave::exporting::shapes {
namespace {

Model with_pane(const studio::Placement& placement) {
  Model model;
  model.name = "stage";
  glass::Pane pane = support::pane_with(12);
  pane.placement = placement;
  model.panes = {support::broken_pane(pane)};
  return model;
}

Model with_pavement(vec2 size_mm) {
  Model model;
  model.name = "stage";
  PavedArea paved;
  paved.pavement.name = "path";
  paved.pavement.area = {{{0, 0}, {size_mm.x, 0}, size_mm, {0, size_mm.y}}, {}};
  model.pavements = {paved};
  return model;
}

// How far out things reach in the picture: 1 is its border.
double reach(const Model& model) {
  const Stage stage = stage_of(model);
  const studio::View view = studio::view_of(stage.camera);
  const double focal = 2.0 * studio::focal_length_mm(stage.camera) / studio::film_width_mm;
  double most = 0.0;
  for (const vec3& p : extents_mm(model)) {
    const vec3 from = p - stage.camera.at_mm;
    const double ahead = glm::dot(from, view.forward);
    EXPECT_GT(ahead, 0.0);
    most = std::max({most, focal * std::abs(glm::dot(from, view.right)) / ahead,
                     focal * studio::aspect_of(stage.camera) * std::abs(glm::dot(from, view.up)) / ahead});
  }
  return most;
}

TEST(Stage, WithoutACameraAllIsSeenAndFillsThePicture) {
  std::vector<Model> models;
  for (const double turn : {0.0, 30.0, 90.0, 180.0, -135.0}) {
    models.push_back(with_pane({{5000.0, -800.0, 1200.0}, Angle::degrees(turn)}));
  }
  models.push_back(with_pavement({4000.0, 1200.0}));
  models.push_back(with_pavement({300.0, 20000.0}));
  Model both = with_pavement({4000.0, 1200.0});
  both.panes = with_pane({}).panes;
  models.push_back(both);
  for (const Model& model : models) {
    EXPECT_LT(reach(model), 0.95);
    EXPECT_GT(reach(model), 0.7);
  }
}

TEST(Stage, APaneIsSeenFromTheSideThatIsHit) {
  for (const double turn : {0.0, 30.0, 90.0, 180.0, -135.0}) {
    const studio::Placement placement{{5000.0, -800.0, 1200.0}, Angle::degrees(turn)};
    const studio::Camera camera = stage_of(with_pane(placement)).camera;
    const vec3 seen_from = studio::upright_of_world(studio::without(camera.at_mm, placement));
    EXPECT_GT(seen_from.z, 100.0) << turn;
    EXPECT_NEAR(seen_from.x, 150.0, 2.0);
    EXPECT_NEAR(seen_from.y, 150.0, 2.0);
  }
}

TEST(Stage, APavementIsSeenFromAboveAndTheSouth) {
  const studio::Camera camera = stage_of(with_pavement({4000.0, 1200.0})).camera;
  EXPECT_GT(camera.at_mm.z, 500.0);
  EXPECT_LT(camera.at_mm.y, 0.0);
}

TEST(Stage, TheSunStandsBehindTheCameraToTheLeft) {
  for (const double turn : {0.0, 90.0, 200.0}) {
    const Stage stage = stage_of(with_pane({{}, Angle::degrees(turn)}));
    const vec3 to_sun = studio::direction_to(*stage.light.sun);
    const studio::View view = studio::view_of(stage.camera);
    EXPECT_LT(glm::dot(to_sun, view.forward), -0.3);
    EXPECT_LT(glm::dot(to_sun, view.right), -0.3);
    EXPECT_GT(to_sun.z, 0.5);
  }
}

TEST(Stage, WhatTheSceneSaysIsTaken) {
  Model model = with_pane({});
  model.camera = studio::Camera{};
  model.camera->at_mm = {1.0, 2.0, 3.0};
  model.light = studio::Light{};
  model.environment = studio::Environment{"png", std::make_shared<const std::string>("bytes")};
  const Stage stage = stage_of(model);
  EXPECT_EQ(stage.camera, *model.camera);
  EXPECT_EQ(stage.light, *model.light);
  EXPECT_EQ(stage.environment, *model.environment);
  EXPECT_EQ(stage.environment_name, "stage_environment.png");
  model.light->environment_blur = Angle::degrees(2.5);
  EXPECT_EQ(stage_of(model).environment_name, "stage_environment_blur2.5.exr");
  // A plain sky has nothing to be out of focus.
  model.environment.reset();
  EXPECT_EQ(stage_of(model).environment_name, "stage_environment.hdr");
}

TEST(Stage, PlacingsLookAlongTheView) {
  const Placing sun = placing_of(studio::Sun{Angle::degrees(90.0), Angle::degrees(0.0), 1.0});
  // From the east, in the frame of bodies (x, y up, z south), light goes along −x.
  EXPECT_LT(glm::length(sun.turned({0.0, 0.0, -1.0}) - vec3{-1.0, 0.0, 0.0}), 1e-12);
  studio::Camera camera;
  camera.at_mm = {10.0, -20.0, 30.0};
  camera.look_at_mm = {10.0, 0.0, 30.0};
  const Placing placing = placing_of(camera);
  EXPECT_EQ(placing.at_mm, (vec3{10.0, 30.0, 20.0}));
  EXPECT_EQ(placing.turned({0.0, 0.0, -1.0}), (vec3{0.0, 0.0, -1.0}));
  EXPECT_EQ(placing.turned({0.0, 1.0, 0.0}), (vec3{0.0, 1.0, 0.0}));
}

// Every point of every body, by the words of studio/world.h; a pane that is turned the other way is no match.
TEST(Stage, BodiesStandWhereTheirThingDoes) {
  const studio::Placement placement{{700.0, -300.0, 50.0}, Angle::degrees(37.0)};
  const auto points = [](const Model& model) {
    std::vector<vec3> all;
    for_each_body(model, materials_of(model), {}, [&](Body&& body) {
      for (const Piece& piece : body.pieces) {
        for (const vec3& p : piece.mesh.points_mm) all.push_back(body.placing(p));
      }
    });
    return all;
  };
  Model shattered;
  shattered.panes = {support::shattered_pane(12)};
  for (const Model& at_home : {with_pane({}), shattered}) {
    Model moved = at_home;
    moved.panes[0].pane.placement = placement;
    const std::vector<vec3> before = points(at_home);
    const std::vector<vec3> after = points(moved);
    ASSERT_EQ(before.size(), after.size());
    ASSERT_GT(before.size(), 100U);
    double worst = 0.0;
    double wrong = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const vec3 world = studio::world_of_upright(before[i]);
      const auto off = [&](Angle turn) {
        return glm::length(studio::upright_of_world(studio::placed(world, {placement.at_mm, turn})) - after[i]);
      };
      worst = std::max(worst, off(placement.turn));
      wrong = std::max(wrong, off(-placement.turn));
    }
    EXPECT_LT(worst, 1e-9);
    EXPECT_GT(wrong, 10.0);
  }
}

}  // namespace
}  // namespace shatterpave::exporting::shapes
