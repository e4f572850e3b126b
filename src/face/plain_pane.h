// Panes of the face from those of the model.
#pragma once

#include <shatterpave/pane.h>

#include "export/model.h"
#include "glass/network.h"
#include "glass/shards/shards.h"

namespace shatterpave::face {

// Each kind by itself, so that the compiler tells of one that the face does not know.
CrackKind plain(glass::CrackKind kind);
CrackEnd::At plain(glass::CrackEnd::At at);
ShardState plain(glass::ShardState state);
ShardSurface plain(glass::ShardSurface surface);

Pane plain(const exporting::BrokenPane& broken);
ShardMesh plain_mesh(const glass::Shard& shard, double thickness_mm);

}  // namespace shatterpave::face
