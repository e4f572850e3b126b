// The periodic bonds, one period each; and those that are generated. Lengths are pitches: a stone and a joint, mm.
#pragma once

#include <cstdint>

#include "core/random.h"
#include "paving/tiles/pattern.h"

namespace shatterpave::paving {

// Rows that move on by `offset` of a stone each; 0 is stack bond.
Pattern rows_pattern(vec2 pitch, double offset);

// Stones along u and along v by turns, in steps. pitch.x >= pitch.y. The period is that of the steps, which run at 45°: u of
// the pattern does, too.
Pattern herringbone_pattern(vec2 pitch);

// Blocks of stones side by side, square, along u and along v by turns.
Pattern basket_weave_pattern(vec2 pitch);

Pattern hexagon_pattern(vec2 pitch);

// Flat arcs with chords of `span_mm` along u, bulging towards +v; one beside the other, and one behind the other by a pitch.
Pattern segmental_arc_pattern(vec2 pitch, double span_mm);

// Fans `span_mm` wide, which open towards +v.
Pattern fan_pattern(vec2 pitch, double span_mm);

// Rectangles of one to six modules of a pitch, mixed; over all of the area.
std::vector<Tile> ashlar_tiles(vec2 pitch, const Placement& placement, const geometry::RegionIndex& area, std::uint64_t seed,
                               Id pavement);

// Irregular convex polygons, one to a pitch² in the mean; over all of the area.
std::vector<Tile> crazy_tiles(vec2 pitch, const Placement& placement, const geometry::RegionIndex& area, std::uint64_t seed,
                              Id pavement);

}  // namespace shatterpave::paving
