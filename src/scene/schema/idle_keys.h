// Keys that a scene gives, but that change nothing beside its other keys. None is passed over in silence: each is told, so that
// someone who turns it and sees no change learns why. When a key has no effect stands in its row (scene/schema/row.h).
//
// `shards.enabled = false` alone says itself that the rest of its table has no effect, and is not told.
#pragma once

#include <vector>

#include "core/notes.h"
#include "glass/pane.h"
#include "paving/pavement.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

// The keys of a [[pane]], of which `pane` was made.
void tell_idle_keys(const TomlTable& table, const glass::Pane& pane, std::vector<Note>& notes);
// The keys of a [[pavement]], of which `pavement` was made, before it was laid out as a flight of steps if it `is_flight`.
void tell_idle_keys(const TomlTable& table, const paving::Pavement& pavement, bool is_flight, std::vector<Note>& notes);
// The keys of the whole scene: [still] and [plan].
void tell_idle_keys(const TomlTable& root, std::vector<Note>& notes);

}  // namespace shatterpave::scene
