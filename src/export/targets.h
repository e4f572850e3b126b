// The table of all targets.
#pragma once

#include <span>

#include "export/target.h"

namespace shatterpave::exporting {

// In the order in which help lists them and files are written; the first is what is written unless another is asked for.
std::span<const Target* const> targets();

}  // namespace shatterpave::exporting
