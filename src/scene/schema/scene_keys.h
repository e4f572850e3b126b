// The keys of the whole scene, one row each.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "scene/schema/row.h"
#include "scene/schema/scene_facts.h"

namespace shatterpave::scene {

// [plan] as it stands in the file.
struct PlanAsked {
  std::optional<vec2> origin;  // in the units of GeoJSON plans
  double svg_scale = 1.0;      // millimetres in the world for one on the page
};

// The settings that a still may have, the templates whose names end in `_still`.
std::vector<std::string_view> settings();

extern const Section<Scene, SceneFacts> root_keys;
extern const Section<Still, SceneFacts> still_keys;
// [light] as it stands in the file.
struct LightAsked {
  studio::Light light;
  studio::Sun sun;
};

extern const Section<studio::Camera, SceneFacts> camera_keys;
extern const Section<LightAsked, SceneFacts> light_keys;
extern const Section<PlanAsked, SceneFacts> plan_keys;

}  // namespace shatterpave::scene
