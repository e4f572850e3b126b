// Keys that a scene gives, but that change nothing beside its other keys. None is passed over in silence: each is told, so that
// someone who turns it and sees no change learns why.
//
// `shards.enabled = false` alone says itself that the rest of its table has no effect, and is not told.
#pragma once

#include <functional>
#include <string>

#include "core/error.h"
#include "glass/pane.h"
#include "paving/pavement.h"
#include "scene/toml_table.h"

namespace shatterpave::scene {

// Is given the key's place, and what to say of it: "has no effect beside radial_count".
using TellIdle = std::function<void(const Place& place, const std::string& message)>;

// The keys of a [[pane]], of which `pane` was made.
void tell_idle_keys(const TomlTable& table, const glass::Pane& pane, const TellIdle& tell);
// The keys of a [[pavement]], of which `pavement` was made, before it was laid out as a flight of steps if it `is_flight`.
void tell_idle_keys(const TomlTable& table, const paving::Pavement& pavement, bool is_flight, const TellIdle& tell);
// The keys of the whole scene: [still] and [plan].
void tell_idle_keys(const TomlTable& root, const TellIdle& tell);

}  // namespace shatterpave::scene
