// Stones share materials by tone: a material of its own for each of many stones is more than renderers bear.
#pragma once

#include <algorithm>
#include <cstddef>

#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::exporting::shapes {

inline constexpr int stone_tones = 24;

// The tone of a stone that drew `colour`, 0 … 1: 0 … stone_tones - 1.
inline int tone_of(double colour) { return std::min(stone_tones - 1, static_cast<int>(colour * stone_tones)); }
// The colour in the middle of a tone.
inline double colour_of(int tone) { return (tone + 0.5) / stone_tones; }

// How many materials the stones of a pavement have: one for each tone, or for each of the user's own colours.
inline std::size_t stone_materials(const paving::Pavement& pavement) {
  const std::size_t own = pavement.look.colours.colours.size();
  return own == 0 ? static_cast<std::size_t>(stone_tones) : own;
}
// Which of them a stone has that drew `colour`.
inline std::size_t material_of(const paving::Stone& stone, double colour) {
  return static_cast<std::size_t>(stone.colour < 0 ? tone_of(colour) : stone.colour);
}

}  // namespace shatterpave::exporting::shapes
