// Outlines as files give them, into regions on the lattice.
#pragma once

#include <vector>

#include "core/error.h"
#include "core/notes.h"
#include "geometry/fill.h"
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
//
// Rings that touch or run along themselves or each other, or cross by no more than the lattice rounds, are read as what the
// outline encloses and no hole does, if that is one region as large as the rings say with all their vertices on its border; it
// is told in `notes`.
geometry::Region region_of(const Ring& outline, const std::vector<Ring>& holes, std::vector<Note>* notes = nullptr);

// The same for rings that may do anything, as in plans: what the outline encloses by the even-odd rule without what any hole
// encloses, which may be several regions. Throws InputError where that is nothing. What makes no region as it is, and spikes
// and holes without area that are left out, are told in `notes`.
std::vector<geometry::Region> regions_of_polygon(const Ring& outline, const std::vector<Ring>& holes,
                                                 std::vector<Note>* notes = nullptr);

using geometry::FillRule;

// The regions that rings fill together, whatever they do, as SVG defines it; rings without area are left out. Where no rings
// cross or touch but in single points, as `region_of`, in the order of their outlines among the rings. One or more rings.
// Throws InputError where they fill nothing.
std::vector<geometry::Region> filled_regions(const std::vector<Ring>& rings, FillRule rule);

// The same, and nothing where they fill nothing.
std::vector<geometry::Region> drawn_regions(const std::vector<Ring>& rings, FillRule rule);

// Whether the ring has three or more points on the lattice that are not all on a line.
bool has_area(const Ring& ring);

// A polyline on the lattice, without repeated points. Throws InputError if fewer than two remain.
std::vector<vec2> line_of(const Ring& line);

// The same region with its rings as `region_of` writes them.
geometry::Region canonical(geometry::Region region);

}  // namespace shatterpave::scene
