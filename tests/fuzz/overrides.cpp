// KEY=VALUE of --set, one a line, over a scene of each kind.
#include <vector>

#include "scene/read_scene.h"
#include "tests/fuzz/harness.h"

using namespace shatterpave;

static constexpr std::string_view scene_text =
    "seed = 7\n[[pane]]\nname = \"window\"\nsize_mm = [300, 300]\n[[pane.impact]]\nat_mm = [150, 150]\n[pane.shards]\n"
    "[[pavement]]\nname = \"path\"\nsize_mm = [4000, 1200]\nstone_mm = [100, 100]\n[pavement.ground]\nkerb_width_mm = 80\n"
    "[camera]\nposition_mm = [0, 0, 2000]\ntarget_mm = [0, 0, 0]\n[light]\nenvironment = \"city\"\n";

SHATTERPAVE_FUZZ(text) {
  std::vector<scene::Override> changes;
  while (!text.empty() && changes.size() < 8) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) continue;
    std::string shown(line);
    for (char& letter : shown) {
      if (letter == '\r') letter = ' ';  // the command line shows control characters as they were given
    }
    changes.push_back({"--set", shown.substr(0, equals), shown.substr(equals + 1)});
  }
  scene::scene_of_text(scene_text, "/nowhere/s.toml", changes);
}
