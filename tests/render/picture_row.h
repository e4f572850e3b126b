// Pictures side by side, as the golden of a case over seeds keeps them.
#pragma once

#include <vector>

#include "relief/raster.h"

namespace shatterpave::render_tests {

// The pictures, one or more of one size, from left to right.
relief::Raster row_of(const std::vector<relief::Raster>& pictures);

// And apart again, each `width` wide.
std::vector<relief::Raster> parts_of(const relief::Raster& row, std::size_t width);

}  // namespace shatterpave::render_tests
