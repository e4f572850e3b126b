// Scene files (TOML), with all that a scene is checked for.
#include "scene/read_scene.h"
#include "tests/fuzz/harness.h"

SHATTERPAVE_FUZZ(text) { shatterpave::scene::scene_of_text(text, "/nowhere/s.toml"); }
