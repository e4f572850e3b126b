// Geometry files (JSON) and the networks of their panes.
#include "scene/cracks_file.h"
#include "tests/fuzz/harness.h"

using namespace shatterpave;

SHATTERPAVE_FUZZ(text) {
  const scene::CracksFile file = scene::cracks_of_file(fuzz::file_with(text, ".json"), {});
  for (const scene::FilePane& pane : file.panes) {
    if (pane.outline) scene::network_of(pane, *pane.outline, pane.impacts);
  }
}
