// What the stones of a pavement lie in and on: bounds, bed, water, and the fall of it all.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "export/povray/stone_text.h"

namespace shatterpave::exporting::povray {

// Declares PREFIX_Bed_Level, PREFIX_Top, PREFIX_Stone_Size, PREFIX_Min and PREFIX_Max.
void append_bounds(std::string& text, const std::string& prefix, const paving::Pavement& pavement, double stone_size_mm);

// Declares PREFIX_Bed. Where the ground has sunk, the solid lies beneath it and a surface over it follows the ground.
void append_bed(std::string& text, const std::string& prefix, const paving::Pavement& pavement, std::uint64_t seed);

// The declaration of PREFIX_Water; nothing where no water stands. At wetness 1 it covers a third of the stones.
std::string water_text(const paving::Pavement& pavement, const std::string& prefix, std::span<const StoneText> stones);

// Fall and level, as the last line of an object; nothing on level ground.
std::string ground_transform(const paving::Pavement& pavement);

}  // namespace shatterpave::exporting::povray
