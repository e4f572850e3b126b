// Outlines of stones taken apart: their corners, and the convex pieces of those that are not convex.
#pragma once

#include <array>
#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::paving {

// The corners of a stone: `outline` without the vertices that lie within `tolerance_mm` of the line through their neighbours;
// three or more remain.
geometry::Polygon corners(const geometry::Polygon& outline, double tolerance_mm);

// Cuts at reflex corners, along the shorter continuation of one of their sides, until no piece has any. Pieces are
// counter-clockwise; vertices that are no corners by `tolerance_mm` are left out.
std::vector<geometry::Polygon> convex_pieces(const geometry::Polygon& outline, double tolerance_mm);

// Leaves out the corner of `polygon`, of four or more, that changes its shape least.
void leave_out_least_corner(geometry::Polygon& polygon);

// Vertex i, counted round and round.
inline const vec2& cyclic(const geometry::Polygon& polygon, std::size_t i) { return polygon[i % polygon.size()]; }
inline const vec2& before(const geometry::Polygon& polygon, std::size_t i) { return cyclic(polygon, i + polygon.size() - 1); }

// Sine and cosine of the turn at corner i, from one side to the next.
double corner_sine(const geometry::Polygon& polygon, std::size_t i);
double corner_cosine(const geometry::Polygon& polygon, std::size_t i);

// The place in `quad` whose corners are at (u, v) = (0, 0), (1, 0), (1, 1), (0, 1).
vec2 bilinear(const std::array<vec2, 4>& quad, double u, double v);

}  // namespace shatterpave::paving
