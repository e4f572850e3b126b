// Stones share materials by tone: a material of its own for each of many stones is more than renderers bear.
#pragma once

#include <algorithm>

namespace shatterpave::exporting::shapes {

inline constexpr int stone_tones = 24;

// The tone of a stone that drew `colour`, 0 … 1: 0 … stone_tones - 1.
inline int tone_of(double colour) { return std::min(stone_tones - 1, static_cast<int>(colour * stone_tones)); }
// The colour in the middle of a tone.
inline double colour_of(int tone) { return (tone + 0.5) / stone_tones; }

}  // namespace shatterpave::exporting::shapes
