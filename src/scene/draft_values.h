// What a scene says, for those who show it to its author with all its keys.
#pragma once

#include <string>

#include "scene/draft.h"

namespace shatterpave::scene {

// JSON: {"values": {…}, "idle": [paths]}. `values` is the file as it is read, with what was set in the draft; lists of more
// than 64 values are left out, as what nobody turns by hand. `idle` are the paths of keys that have no effect
// (`pane[0].tempering`), whether they are given or not.
//   scene  that of the draft
std::string draft_values(const Draft& draft, const Scene& scene);

}  // namespace shatterpave::scene
