// Shards that leave a pane fall to the sill or the floor and come to rest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glass/shards/lean.h"
#include "glass/shards/shards.h"

namespace shatterpave::glass {

// Where the rigid bodies have the shards of state `fallen` so long after the first of them is let go, at each of the times,
// which must not fall: one list a time, in the order of `shards`; those of other states keep theirs. The engine goes by steps
// of 1/800 s, and the last step that was done by then counts: no place is made up between two.
//   0 s                   all that left the pane, missing or not, is in it yet: standing
//   later                 what has not been let go yet is in the pane, what has is where its body is; missing is gone
//   when all are at rest  each lies where it came to rest; one that does not come to rest is missing
// A step is done in parts while anything comes fast to something, so that nothing reaches into anything by more than 0.5 mm.
// Bodies are bent as the pane is, and their walls lean by the field.
// The same bits whatever other times are asked for. Throws InputError where too many fall.
std::vector<std::vector<ShardPlace>> places_of_fall(const Pane& pane, const std::vector<Shard>& shards, std::uint64_t seed,
                                                    std::span<const double> times_s, const Lean& lean = {});

// Puts the shards where they are at the pane's time_s; without one, where they come to rest: at infinity, for which more than
// 300 pieces go by whole steps, so that they come to lie elsewhere than at the end of a fall that is seen.
void let_fall(const Pane& pane, std::vector<Shard>& shards, std::uint64_t seed, const Lean& lean = {});

}  // namespace shatterpave::glass
