// Outlines as files give them, into regions on the lattice.
#pragma once

#include <vector>

#include "core/error.h"
#include "geometry/polygon.h"

namespace shatterpave::scene {

// Points in succession as they were given, with their place, for messages. As a ring: either winding, the first point repeated
// at the end or not.
struct Ring {
  std::vector<vec2> points_mm;
  Place place;
};

// Limits of one outline with its holes, against input that would take all memory.
inline constexpr std::size_t most_vertices = 1'000'000;
inline constexpr std::size_t most_holes = 10'000;

// The region of an outline with holes, the same however its rings are written: points are moved to the lattice (to the nearest
// µm); repeated ones, those on the straight line between their neighbours, and spikes without width are left out; the outline
// runs counter-clockwise, holes clockwise, each from its leftmost vertex (of several, the lowest). Throws InputError, at the
// place of the ring, where the rings make no region; an edge has the number of the given point where it starts, from 0.
geometry::Region region_of(const Ring& outline, const std::vector<Ring>& holes);

enum class FillRule { nonzero, evenodd };  // as SVG has them

// The regions that rings fill, in the order of their outlines among the rings: as `region_of`, but any ring may lie in any
// other, and rings without area are left out. Rings may not cross; they may touch in single points. One or more rings.
std::vector<geometry::Region> filled_regions(const std::vector<Ring>& rings, FillRule rule);

// A polyline on the lattice, without repeated points. Throws InputError if fewer than two remain.
std::vector<vec2> line_of(const Ring& line);

// The same region with its rings as `region_of` writes them.
geometry::Region canonical(geometry::Region region);

}  // namespace shatterpave::scene
