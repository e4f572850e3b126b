// Panes of the face from those of the model.
#pragma once

#include <shatterpave/pane.h>

#include "export/model.h"
#include "glass/network.h"
#include "glass/pane.h"
#include "glass/shards/shards.h"

namespace shatterpave::face {

// One function for each kind, so that a kind that the public headers lack does not compile.
CrackKind plain(glass::CrackKind kind);
CrackEnd::At plain(glass::CrackEnd::At at);
ShardState plain(glass::ShardState state);
ShardSurface plain(glass::ShardSurface surface);

Pane plain(const exporting::BrokenPane& broken);
// As it is bent with its pane.
ShardMesh plain_mesh(const glass::Shard& shard, const glass::Pane& pane);

}  // namespace shatterpave::face
