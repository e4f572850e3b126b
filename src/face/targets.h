// The targets that the face offers: those of the table of export.
#pragma once

#include <string_view>

#include "export/target.h"

namespace shatterpave::face {

// Throws InputError where there is no target of that name.
const exporting::Target& target_named(std::string_view name);

}  // namespace shatterpave::face
