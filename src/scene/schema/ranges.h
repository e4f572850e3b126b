// Ranges that a row and the code that reads its key share.
#pragma once

#include <cstddef>

#include "geometry/lattice.h"
#include "paving/limits.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

inline constexpr Range coordinate_range{-geometry::largest_coordinate_mm, geometry::largest_coordinate_mm};
inline constexpr Range size_range{0.0, geometry::largest_coordinate_mm, true};
// Of lines and points of a plan that become bands and discs.
inline constexpr Range width_range{1.0, 100'000.0};
// Of a drawing: millimetres in the world for one on its page.
inline constexpr Range svg_scale_range{0.001, 100'000.0};
// A quarter of an hour, in which a crack of any speed has crossed any pane that is worth a picture.
inline constexpr Range time_us_range{0.0, 1e9};
inline constexpr double largest_spall_mm = 10'000.0;
inline constexpr std::size_t most_guides = 10'000;
// Of [[pavement.colour]]: more are told apart by nobody. Of places away from which they follow one another, each stone looks
// for the nearest.
inline constexpr std::size_t most_colours = 64;
inline constexpr std::size_t most_attractors = 1000;

// The range of a key whose bounds another room has.
constexpr Range range_of(const paving::Bounds& bounds) { return {bounds.low, bounds.high}; }

}  // namespace shatterpave::scene
