// The include file of a broken pane for POV-Ray.
#pragma once

#include <cstdint>
#include <string>

#include "export/model.h"

namespace shatterpave::exporting::povray {

// `NAME.inc`: a slab of glass, the tubes of its cracks (see tubes.h) and its crushed zones.
// Where the scene asks for shards, they stand in place of slab, tubes and zones (see shards.h).
//   prefix  of the identifiers
//   seed    by which dirt is drawn
OutputFile pane_include(const BrokenPane& broken, const std::string& prefix, std::uint64_t seed);

}  // namespace shatterpave::exporting::povray
