// The keys of a [[pavement]] that say how its stones are worked, how they look, and how the ground lies.
#pragma once

#include "paving/pavement.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

// [pavement.surface], [pavement.variation], [pavement.relief]: a finish first, then what is given beside it.
void read_stones(const TomlTable& pavement, paving::Pavement& result);

// `material`, `joint_fill`, `moss`, `wetness`.
paving::Look look_of(const TomlTable& pavement);

// [pavement.ground], but for its kerb.
paving::Ground ground_of(const TomlTable& pavement);

// [pavement.detail]
std::optional<paving::Detail> detail_of(const TomlTable& pavement);

// The keys of [pavement.ground] that begin with `kerb`.
paving::Kerb kerb_of(const TomlTable& pavement);

}  // namespace shatterpave::scene
