// Small scenes of the public face.
#pragma once

#include <shatterpave/model.h>
#include <shatterpave/scene.h>

#include <string>

#include "export/json/geometry_json.h"
#include "face/model_access.h"

namespace shatterpave {

inline Scene small_pane() {
  Scene scene("pane");
  scene.set("seed", 3);
  scene.add_pane("window", {{0, 0}, {300, 0}, {300, 200}, {0, 200}});
  const std::string impact = scene.add_impact("window", {150, 100});
  scene.set(impact + ".radial_count", 12).set(impact + ".large_count", 9).set(impact + ".circular_count", 4);
  return scene;
}

inline Scene small_yard() {
  Scene scene("yard");
  scene.set("seed", 5);
  scene.add_pavement("court", {{0, 0}, {1000, 0}, {1000, 800}, {0, 800}}, {{{400, 300}, {400, 500}, {600, 500}}});
  scene.set("pavement.court.stone_mm", Point{200, 100});
  scene.set("pavement.court.bond", "running");
  return scene;
}

// As export_files gives it, which tests of other things do without: it loads what reads pictures.
inline std::string json_of(const Model& model) { return exporting::json::json_file(ModelAccess::model(model)).content; }

}  // namespace shatterpave
