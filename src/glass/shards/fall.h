// Shards that leave a pane fall to the sill or the floor and come to rest.
#pragma once

#include <cstdint>
#include <vector>

#include "glass/shards/shards.h"

namespace shatterpave::glass {

// Gives every fallen shard the motion to where it comes to rest; one that does not come to rest becomes missing.
void let_fall(const Pane& pane, std::vector<Shard>& shards, std::uint64_t seed);

}  // namespace shatterpave::glass
