// Ranges of frames, which must read back as they are written.
#include "scene/frame_range.h"
#include "tests/fuzz/harness.h"

using namespace shatterpave;

SHATTERPAVE_FUZZ(text) {
  const std::vector<int> frames = scene::frames_of_range(text, {});
  if (scene::frames_of_range(scene::range_text(frames), {}) != frames) std::abort();
}
