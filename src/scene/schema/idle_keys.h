// Keys that a scene gives but that change nothing beside its other keys. Each of them is reported, so that someone who turns it
// and sees no change learns why. When a key has no effect stands in its row (scene/schema/row.h).
//
// After `shards.enabled = false` the rest of that table is not reported: that it has no effect is plain.
#pragma once

#include <string>
#include <vector>

#include "core/notes.h"
#include "glass/pane.h"
#include "paving/pavement.h"
#include "scene/scene.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

// The keys of a [[pane]], of which `pane` was made.
void tell_idle_keys(const TomlTable& table, const glass::Pane& pane, std::vector<Note>& notes);
// The keys of a [[pavement]], of which `pavement` was made.
void tell_idle_keys(const TomlTable& table, const paving::Pavement& pavement, std::vector<Note>& notes);
// The keys of the whole scene: [still] and [plan].
void tell_idle_keys(const TomlTable& root, std::vector<Note>& notes);

// All keys that would have no effect, whether they are given or not: `growth.apex_deg`, or `growth` where none of that table
// has one. `root`, of which `scene` was made, gives them from the root: `pane[0].tempering`.
std::vector<std::string> idle_key_paths(const TomlTable& root, const Scene& scene);

}  // namespace shatterpave::scene
