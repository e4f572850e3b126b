// Boolean operations and offsets of polygons by Clipper (polyclipping), on the lattice.
//
// Operands are read as the sets of points that they enclose. Results are regions on the lattice: outlines counter-clockwise,
// holes clockwise, without repeated or collinear vertices. A vertex where two sides cross is rounded to the lattice, so a
// side of a result may stray by up to 1 µm from the side it came from; whoever needs strict separation offsets inwards
// by more than that.
#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::geometry {

std::vector<Region> intersection(const Polygon& subject, const Region& clip);
std::vector<Region> intersection(const Region& subject, const Region& clip);
std::vector<Region> difference(const Region& subject, const std::vector<Polygon>& removed);
std::vector<Region> difference(const Region& subject, const std::vector<Region>& removed);
std::vector<Region> united(const std::vector<Polygon>& polygons);
std::vector<Region> united(const std::vector<Region>& regions);

// The region moved in (distance < 0: its points farther than that from its border) or out (> 0: all points nearer to it
// than that). Corners are mitred where the tip lies within `miter_limit` distances, else cut square.
std::vector<Region> offset(const Region& region, double distance_mm, double miter_limit = 2.0);

// The points nearer than `distance_mm` > 0 to polylines of two or more distinct points, which end square. Mitres as in
// `offset`.
std::vector<Region> thickened(const std::vector<std::vector<vec2>>& polylines, double distance_mm, double miter_limit = 2.0);

// `polygon` without repeated vertices, spikes and vertices on the straight line between their neighbours, rounded to the
// lattice; empty if nothing with an area remains.
Polygon cleaned(const Polygon& polygon);

// Whether no two sides meet except neighbours in their common vertex; exact. Tests all pairs of sides: for small polygons.
bool is_simple(const Polygon& polygon);

}  // namespace shatterpave::geometry
