// Vectors of a direction field: a CSV, or a JSON where the first byte is a brace.
#include "scene/direction_file.h"
#include "tests/fuzz/harness.h"

using namespace shatterpave;

SHATTERPAVE_FUZZ(text) {
  const bool is_json = !text.empty() && text.front() == '{';
  scene::direction_of_file(fuzz::file_with(text, is_json ? ".json" : ".csv"), {}, {{0.0, 0.0}, {4000.0, 3000.0}});
}
