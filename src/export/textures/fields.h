// The random fields that a pavement's textures are made of.
#pragma once

#include <cstdint>

#include "paving/pavement.h"
#include "relief/height_field.h"

namespace shatterpave::exporting::textures {

struct Fields {
  relief::HeightField relief;   // of the stones, the same as that of other targets
  double relief_side_mm = 1.0;  // of its period
  relief::HeightField grain;    // about a millimetre wide, of rms 1: of the sand, and, taken larger, of the minerals of stone
};

inline constexpr double grain_side_mm = 64.0;  // of the period of the grain, in sand

Fields fields_of(const paving::Pavement& pavement, std::uint64_t seed);

}  // namespace shatterpave::exporting::textures
