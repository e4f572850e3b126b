// A shard as a closed solid: front, back and walls, with bevels and chips along its edges.
#pragma once

#include <cstdint>
#include <vector>

#include "core/random.h"
#include "core/vec.h"
#include "geometry/polygon.h"
#include "geometry/solid.h"
#include "glass/pane.h"
#include "glass/shards/lean.h"

namespace shatterpave::glass {

struct ShardBlank {
  geometry::Region region;  // in the pane's plane
  // For each ring, the outline first, whether the side from a vertex to the next one is of the pane's old edge, not of a crack.
  std::vector<std::vector<bool>> is_old;
  double thickness_mm = 0.0;
  Id id;  // for its chips
};

// Flakes off the broken edges of the two faces.
struct Chip {
  vec2 at_mm{0.0, 0.0};    // on the border
  geometry::Polygon bite;  // what it takes of the face
};
struct Chips {
  std::vector<Chip> front;
  std::vector<Chip> back;
};
Chips chips(const ShardBlank& blank, const ShardRules& rules, std::uint64_t seed);

// Slots are ShardSurface, z runs from 0 to the thickness. The flat parts of front and back are smaller than the region by the
// bevel and by chips; where nothing of one would be left, that side stays sharp. Where a neck is narrower than two bevels there
// are several, and a ridge leads from one to the next.
// Where walls lean, flat parts are those of the region as it is shifted at the two faces, and walls go from one to the other in
// four rows. Nothing is made, not a triangle, where sides of a piece that is very narrow would then meet.
//   REQUIRES  no two rings touch
geometry::Solid shard_solid(const ShardBlank& blank, const ShardRules& rules, const Chips& chips, const Lean& lean = {});

}  // namespace shatterpave::glass
