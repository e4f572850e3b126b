// What targets that draw or read pictures make of a model.
#pragma once

#include "export/target.h"

namespace shatterpave::exporting {

// Adds the files of any target, with pictures or without.
void append_files(const Target& target, const Model& model, Outputs& outputs);

}  // namespace shatterpave::exporting
