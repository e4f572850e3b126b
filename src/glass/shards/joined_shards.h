// Faces that stand side by side as one body: no gap, bevel or wall between what has not moved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/planar_map.h"
#include "glass/shards/lean.h"
#include "glass/shards/shard_faces.h"
#include "glass/shards/shard_pieces.h"
#include "glass/shards/shards.h"

namespace shatterpave::glass {

struct JoinedFace {
  std::vector<std::size_t> faces;  // of the pane's, ascending, two or more
  geometry::Face face;             // of the segments of FacedPane; without spurs
};

// What faces that stand, and that have a segment in common from one to the next, make together. The border is that of the map
// without the segments between them: exact, so the area is the sum of theirs.
//   stands  for each face of the pane
std::vector<JoinedFace> joined_faces(const FacedPane& faced, const std::vector<bool>& stands);

// The shards of the pane with their solids, those that stand joined. A piece of which the hole leaves nothing when it cuts the
// joint stands alone.
//   pieces  all of the pane
//   shards  what has become of each, without solids
std::vector<Shard> joined_shards(const Pane& pane, const FacedPane& faced, const std::vector<geometry::Region>& hole,
                                 const std::vector<ShardPiece>& pieces, std::vector<Shard> shards, std::uint64_t seed,
                                 const Lean& lean = {});

}  // namespace shatterpave::glass
