// The numbers that bound a pavement, each with its reason. The scene's keys take their ranges from here, and the rooms that
// check a pavement for whoever calls them without a scene file take the same numbers.
#pragma once

#include <cstddef>

namespace shatterpave::paving {

// Pavements of a scene, where each area and each step of a flight is one.
inline constexpr std::size_t most_pavements = 1000;

// Both ends belong to it.
struct Bounds {
  double low = 0.0;
  double high = 0.0;
};

// A millimetre is far above the lattice of 1 µm on which stones are cut; 100 m is more than any stone. Laying checks the lower
// ends only, since stones that follow from others, such as those of round steps, may be longer than one that is asked for.
inline constexpr Bounds stone_bounds_mm{1.0, 100'000.0};
inline constexpr Bounds joint_bounds_mm{0.0, 1000.0};
// Of `Bonding::span_mm`. If it is not 0, it must also be at least five stones wide, since fewer make no arc (laying.cpp).
inline constexpr Bounds span_bounds_mm{0.0, 1'000'000.0};
// Of the sizes of packed stones, as a part of the one that is asked for: within, stones of a plan differ by sixteen times each
// way. The grid on which sizes are sampled must tell the smallest (paving/field/size_field.cpp).
inline constexpr Bounds size_bounds{0.25, 4.0};
// Of `Bonding::offset`, a part of a stone.
inline constexpr Bounds offset_bounds{0.0, 1.0};
// Half of it is joint at the most, and stones are at least a millimetre wide. 0 is no kerb.
inline constexpr Bounds kerb_bounds_mm{2.0, 10'000.0};

// Stones of one pavement, estimated from its area and its border (laying.cpp). Memory is about 1.5 kB a stone at the peak; so
// many fit 4 GiB.
inline constexpr double most_stones = 2e6;
// Stones of one seamless tile (seamless.cpp): a texture of 16,384 pixels has 16 of them a side for each of a thousand stones.
inline constexpr double most_tile_stones = 1e6;

// Bonds in arcs (laying.cpp): fewer stones make no arc.
inline constexpr double least_stones_to_a_span = 5.0;

}  // namespace shatterpave::paving
