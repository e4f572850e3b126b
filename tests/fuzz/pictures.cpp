// Pictures that fields and sizes follow: OpenEXR, or PNG where the first byte is that of one.
#include "scene/direction_file.h"
#include "scene/grey_map_file.h"
#include "tests/fuzz/harness.h"

using namespace shatterpave;

SHATTERPAVE_FUZZ(text) {
  if (!text.empty() && text.front() == '\x89') {
    scene::grey_map_of_file(fuzz::file_with(text, ".png"), {});
  } else {
    scene::direction_of_file(fuzz::file_with(text, ".exr"), {}, {{0.0, 0.0}, {4000.0, 3000.0}});
  }
}
