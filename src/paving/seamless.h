// A tile of a pavement that meets itself on all sides, for textures that are repeated.
#pragma once

#include <cstdint>

#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::paving {

// The stones of one tile, each once. With all of them again at every whole multiple of `size_mm.x` along x and of `size_mm.y`
// along y they pave the plane. Some reach beyond the tile, whose lower left corner is (0, 0).
struct SeamlessTile {
  vec2 size_mm{0.0, 0.0};
  StoneLayout layout;
};

// The tile of the pavement's bond, whatever its area: `textures.tile_mm` wide and high or, where that is not given, near ten
// stones. So that whole periods of the bond fit into it, stones become longer, wider or more slanting by up to
// `most_stretch`; joints keep their width. Variation and missing stones are as in the pavement. A pure function of its
// arguments. Throws InputError where the bond does not repeat, or not over that size, with one that would do.
SeamlessTile seamless_tile(const Pavement& pavement, std::uint64_t seed);

// Throws what `seamless_tile` would, without laying a stone.
void require_seamless(const Pavement& pavement);

inline constexpr double most_stretch = 0.03;  // by eye: 3 mm on a sett of 100 mm, less than hewn setts differ by

}  // namespace shatterpave::paving
