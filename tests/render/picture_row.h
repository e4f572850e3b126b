// Pictures put together and taken apart.
#pragma once

#include <vector>

#include "relief/raster.h"

namespace shatterpave::render_tests {

// The pictures, one or more of one size, from left to right, as the golden of a case over seeds keeps them.
relief::Raster row_of(const std::vector<relief::Raster>& pictures);

// And apart again, each `width` wide.
std::vector<relief::Raster> parts_of(const relief::Raster& row, std::size_t width);

// A picture of 1/factor of the size, each pixel the mean of factor x factor. The size must be a multiple of it.
relief::Raster shrunk(const relief::Raster& picture, std::size_t factor);

}  // namespace shatterpave::render_tests
