#include "export/shapes/stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "geometry/polygon.h"
#include "paving/surface/ground.h"
#include "paving/surface/stone_surface.h"
#include "studio/plain_sky.h"
#include "studio/world.h"

namespace shatterpave::exporting::shapes {

namespace {

using studio::placed;
using studio::world_of_upright;

// By eye: how much wider than the things the picture is, how steeply pavements are looked at, and panes where there are both.
constexpr double picture_margin = 1.12;
constexpr Angle onto_pavement = Angle::degrees(35.0);
constexpr Angle onto_both = Angle::degrees(15.0);
// The same: the sun beside and above a camera that it looks over the shoulder of.
constexpr Angle sun_aside = Angle::degrees(40.0);
constexpr Angle sun_elevation = Angle::degrees(40.0);

void append_extents(const BrokenPane& broken, std::vector<vec3>& extents) {
  const glass::Pane& pane = broken.pane;
  const auto put = [&](vec3 p) { extents.push_back(placed(world_of_upright(p), pane.placement)); };
  const geometry::Bend bend = glass::bend_of(pane);
  for (const vec2& p : pane.outline_mm) {
    for (const double side : {-0.5, 0.5}) put(bend.point({p, side * pane.thickness_mm}));
  }
  if (!bend.is_flat()) {
    // The hull of these and of the outline holds the bent pane, but for a hair at its border.
    const vec2 low = bend.middle_mm - bend.half_mm;
    const vec2 high = bend.middle_mm + bend.half_mm;
    for (const double height : {glm::min(bend.bow_mm.x, 0.0) + glm::min(bend.bow_mm.y, 0.0) - pane.thickness_mm,
                                glm::max(bend.bow_mm.x, 0.0) + glm::max(bend.bow_mm.y, 0.0) + pane.thickness_mm}) {
      for (const vec2 p : {low, vec2{high.x, low.y}, high, vec2{low.x, high.y}}) put({p, height});
    }
  }
  for (const glass::Shard& shard : broken.shards) {
    if (shard.state != glass::ShardState::fallen) continue;
    for (const geometry::LatticePoint3& vertex : shard.solid.vertices) {
      put(glass::moved(shard.motion, bend.point(glass::in_pane_mm(vertex, pane.thickness_mm))));
    }
  }
}

void append_extents(const paving::Pavement& pavement, std::vector<vec3>& extents) {
  const vec2 slope = paving::fall(pavement.ground);
  for (const vec2& p : pavement.area.outline) {
    const double ground_mm = pavement.ground.level_mm + glm::dot(slope, p);
    for (const double height_mm : {0.0, paving::top_mm(pavement)}) {
      extents.push_back(placed({p, ground_mm + height_mm}, pavement.placement));
    }
  }
}

// Where from, as a unit vector, the panes are seen, level: from before the side that is hit.
vec2 before_panes(const Model& model) {
  vec2 sum{0.0, 0.0};
  double areas = 0.0;
  for (const BrokenPane& broken : model.panes) {
    const double area = std::abs(geometry::area(broken.pane.outline_mm));
    sum += area * rotated({0.0, -1.0}, broken.pane.placement.turn);
    areas += area;
  }
  const double length = glm::length(sum);
  // Those that look to all sides have no side in common. By eye: below a third.
  return length > areas / 3.0 ? sum / length : vec2{0.0, -1.0};
}

vec3 rounded(vec3 p_mm) { return {std::round(p_mm.x) + 0.0, std::round(p_mm.y) + 0.0, std::round(p_mm.z) + 0.0}; }

studio::Camera camera_onto(const Model& model) {
  const std::vector<vec3> extents = extents_mm(model);
  if (extents.empty()) return {};
  vec3 low = extents.front();
  vec3 high = low;
  for (const vec3& p : extents) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  Angle down = model.panes.empty() ? onto_pavement : Angle();
  if (!model.panes.empty() && !model.pavements.empty()) down = onto_both;
  const vec2 level = before_panes(model);
  const vec2 steep = down.direction();
  const vec3 back{steep.x * level, steep.y};

  studio::Camera camera;
  camera.look_at_mm = rounded(0.5 * (low + high));
  camera.at_mm = camera.look_at_mm + back;
  const studio::View view = studio::view_of(camera);
  const double aspect = studio::aspect_of(camera);
  const double focal = 2.0 * studio::focal_length_mm(camera) / studio::film_width_mm;
  double distance = 1.0;
  for (const vec3& p : extents) {
    const vec3 from = p - camera.look_at_mm;
    const double aside = std::max(std::abs(glm::dot(from, view.right)), aspect * std::abs(glm::dot(from, view.up)));
    distance = std::max(distance, picture_margin * focal * aside - glm::dot(from, view.forward));
  }
  camera.at_mm = rounded(camera.look_at_mm + std::ceil(distance) * back);
  return camera;
}

studio::Light plain_light(const studio::Camera& camera) {
  const vec3 back = camera.at_mm - camera.look_at_mm;
  // An azimuth is clockwise from +y. To the left of who looks along the view is clockwise as seen from behind the camera.
  const Angle behind = Angle::of({back.y, back.x});
  studio::Light light;
  light.sun = studio::Sun{(behind + sun_aside).wrapped(), sun_elevation, 1.0};
  return light;
}

Placing placing(vec3 right, vec3 up, vec3 forward, vec3 at_mm) {
  const vec3 x = studio::upright_of_world(right);
  const vec3 y = studio::upright_of_world(up);
  const vec3 z = -studio::upright_of_world(forward);
  return {{vec3{x.x, y.x, z.x}, vec3{x.y, y.y, z.y}, vec3{x.z, y.z, z.z}}, studio::upright_of_world(at_mm)};
}

}  // namespace

std::vector<vec3> extents_mm(const Model& model) {
  std::vector<vec3> extents;
  for (const BrokenPane& broken : model.panes) append_extents(broken, extents);
  for (const PavedArea& paved : model.pavements) append_extents(paved.pavement, extents);
  return extents;
}

Stage stage_of(const Model& model) {
  Stage stage;
  stage.camera = model.camera ? *model.camera : camera_onto(model);
  stage.camera_path = model.camera_path;
  stage.light = model.light ? *model.light : plain_light(stage.camera);
  if (model.environment) {
    stage.environment = *model.environment;
  } else {
    stage.environment = {"hdr", std::make_shared<const std::string>(studio::plain_sky_hdr())};
    stage.light.environment_blur = Angle();
  }
  // Frames that share files may differ in how far they are out of focus.
  const double blur = stage.light.environment_blur.degrees();
  stage.environment_name = blur > 0.0 ? fmt::format("{}_environment_blur{:.9g}.exr", shared_stem_of(model), blur)
                                      : fmt::format("{}_environment.{}", shared_stem_of(model), stage.environment.ending);
  return stage;
}

Placing placing_of(const studio::Camera& camera) {
  const studio::View view = studio::view_of(camera);
  return placing(view.right, view.up, view.forward, camera.at_mm);
}

std::vector<std::optional<Placing>> camera_placings(const Stage& stage) {
  std::vector<std::optional<Placing>> path;
  path.reserve(stage.camera_path.size());
  for (const studio::Camera& camera : stage.camera_path) path.emplace_back(placing_of(camera));
  return path;
}

Placing placing_of(const studio::Sun& sun) {
  studio::Camera along;
  along.at_mm = studio::direction_to(sun);
  along.look_at_mm = {0.0, 0.0, 0.0};
  Placing turned = placing_of(along);
  turned.at_mm = {0.0, 0.0, 0.0};
  return turned;
}

}  // namespace shatterpave::exporting::shapes
