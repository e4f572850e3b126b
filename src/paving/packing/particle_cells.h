// From a packing to closed regions, one for each particle (§4 of Miyata and Itoh).
#pragma once

#include <span>

#include "paving/packing/particle.h"
#include "paving/pavement.h"
#include "paving/tiles/cells.h"

namespace shatterpave::paving {

// The cells of a packing for the pavement. Four meet in a corner, or three where the stones of two rows lie shifted.
Cells cells_of(std::span<const Particle> particles, const Pavement& pavement);

}  // namespace shatterpave::paving
