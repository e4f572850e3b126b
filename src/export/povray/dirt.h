// Dirt on panes for POV-Ray: a layer over the smooth faces, as templates/includes/shatterpave_dirt.inc draws it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "export/model.h"

namespace shatterpave::exporting::povray {

// #declare PREFIX_Dirt, the texture that lies over that of the faces; nothing for a pane that is clean. Each pane has dirt of
// its own, by `seed` and its name. It stays on pieces that fall.
std::string dirt_text(const glass::Pane& pane, const std::string& prefix, std::uint64_t seed);

// What the header of the include file says of it; nothing for a pane that is clean.
std::vector<std::string> dirt_lines(const glass::Pane& pane, const std::string& prefix);

}  // namespace shatterpave::exporting::povray
