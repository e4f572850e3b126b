// Where a packing starts: particles that already stand in rows and columns along the direction field.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/region_index.h"
#include "paving/field/direction_field.h"
#include "paving/field/size_field.h"
#include "paving/packing/particle.h"

namespace shatterpave::paving {

// A border runs along the rows if the sine of the angle between them is less: 12°.
inline constexpr double along_sine = 0.2079;

// Exact rows of one direction, anchored where the box about the area, turned into the rows' frame, has its lower left
// corner, so that whole stones start there.
std::vector<Particle> straight_rows(const geometry::RegionIndex& area, vec2 along, vec2 pitch, double band_mm);

// Rows along any field, as regular as the field allows, beginning half a pitch from borders that run along or across them.
std::vector<Particle> rows_along(const DirectionField& field, const SizeField& sizes, const geometry::RegionIndex& area,
                                 vec2 pitch, double band_mm, std::uint64_t seed);

}  // namespace shatterpave::paving
