// Breaks a pane and writes its geometry, by what is installed alone, beside headers and types of its own of the same names.
#include <shatterpave/shatterpave.h>

#include <cstring>
#include <iostream>

#include "core/error.h"
#include "glass/pane.h"
#include "scene/scene.h"

static_assert(consumer_has_its_own_error);

int main() {
  const Scene play;
  const Pane title{"three acts"};
  if (play.acts != 3 || length(title) != 10) return 1;
  if (std::strcmp(shatterpave::version(), SHATTERPAVE_VERSION) != 0) return 1;

  shatterpave::Scene scene("scene");
  scene.set("seed", 3);
  const std::string pane = scene.add_pane("window");
  scene.set(pane + ".size_mm", shatterpave::Point{300, 300});
  const std::string impact = scene.add_impact("window", {150, 150});
  scene.set(impact + ".radial_count", 24);
  std::cout << shatterpave::export_files(shatterpave::generate(scene), "json").at(0).content;
}
