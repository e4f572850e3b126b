// Pavements of the face from those of the model.
#pragma once

#include <shatterpave/pavement.h>

#include "export/model.h"
#include "paving/stones.h"

namespace shatterpave::face {

// One function for each kind, so that a kind that the public headers lack does not compile.
StoneKind plain(paving::StoneKind kind);
StonePart plain(paving::StonePart part);

Pavement plain(const exporting::PavedArea& paved);

}  // namespace shatterpave::face
