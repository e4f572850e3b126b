// The shards of a pane for POV-Ray: each a closed mesh, no two of which touch.
#pragma once

#include <string>
#include <vector>

#include "export/model.h"

namespace shatterpave::exporting::povray {

// Appends declarations of the shards that are not missing; see shard_declarations for what they are.
//   prefix      of the identifiers
//   has_cracks  whether PREFIX_Cracks is declared: tubes within shards, which are put there with them
void append_shards(std::string& text, const BrokenPane& broken, const std::string& prefix, bool has_cracks);

// Lines for the header of the include file.
std::vector<std::string> shard_declarations(const std::string& prefix, bool has_cracks);

}  // namespace shatterpave::exporting::povray
