// The spectrum of a periodic height field.
#pragma once

#include "relief/height_field.h"

namespace shatterpave::relief {

// Least-squares slope of log power against log wave number, over rings of the spectrum from `first` to `last` waves over the
// side, which is a power of two.
double spectral_slope(const HeightField& field, double first, double last);

}  // namespace shatterpave::relief
