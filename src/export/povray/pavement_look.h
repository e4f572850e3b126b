// The textures of a pavement: which macro of templates/includes/shatterpave_stone.inc and
// templates/includes/shatterpave_materials.inc makes them.
#pragma once

#include <string>

#include "paving/pavement.h"

namespace shatterpave::exporting::povray {

// Declares the macros PREFIX_Stone_Texture(Tone) and PREFIX_Bed_Texture(), where an artist has not declared them before.
std::string texture_macros(const paving::Pavement& pavement, const std::string& prefix, double relief_side_mm);

// Whether they need templates/includes/shatterpave_materials.inc.
bool uses_materials(const paving::Pavement& pavement);

}  // namespace shatterpave::exporting::povray
