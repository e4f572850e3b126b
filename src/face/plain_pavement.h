// Pavements of the face from those of the model.
#pragma once

#include <shatterpave/pavement.h>

#include "export/model.h"
#include "paving/stones.h"

namespace shatterpave::face {

// Each kind by itself, so that the compiler tells of one that the face does not know.
StoneKind plain(paving::StoneKind kind);
StonePart plain(paving::StonePart part);

Pavement plain(const exporting::PavedArea& paved);

}  // namespace shatterpave::face
