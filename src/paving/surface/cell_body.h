// Bodies of cells in organic textures: cobbles of a beach, scales of a reptile (the use of square packing that §5 of Miyata and
// Itoh leaves to others).
//
// Seen from above a cell is the superellipse of its outline: with n_i · p <= a_i the sides of the convex outline about its
// middle, the points where Σ max(0, n_i · p / a_i)^e = 1. It touches the middles of the sides and rounds the corners off: of a
// square it is Lamé's curve. So it lies within the outline, and cells never overlap in plan. Where scales do, it is their
// bodies: a scale is larger than its cell, its tip goes on over the cells before it, and where two lie over one another the
// higher is seen.
//
// A body is a grid of patches over the square, mapped to the disc and from there to the superellipse. Values and derivatives at
// the nodes are those of the surface, so that neighbouring patches share borders and tangent planes; none has a collapsed edge.
#pragma once

#include <cstdint>
#include <vector>

#include "core/random.h"
#include "geometry/bezier_patch.h"
#include "geometry/polygon.h"
#include "paving/pavement.h"

namespace shatterpave::paving {

// What a cell draws for itself.
struct CellDraws {
  CellForm form = CellForm::cobble;
  double height_mm = 0.0;  // of its highest point above its border
  double exponent = 4.0;   // e, 2 (an ellipse) and more
  double overlap = 0.0;    // as CellShape has it
  vec2 apex{0.0, 0.0};     // cobble: how far its top lies beside its middle, as a part of its size
  vec2 dent{0.0, 0.0};     // cobble: by how much it is drawn in, along x and along the bisector of x and y
  vec2 slope{0.0, 0.0};    // tilt: rise per mm along x and y
  vec2 heading{1.0, 0.0};  // scale: unit vector, to its tip
};

// All but the heading.
CellDraws cell_draws(const Pavement& pavement, std::uint64_t seed, Id stone);

// The patches over `outline`, convex and counter-clockwise: z is 0 at their border. Normals, derivative_u × derivative_v, point
// up. Those of a cobble lie within the outline.
std::vector<geometry::BezierPatch> cell_patches(const geometry::Polygon& outline, const CellDraws& draws);

// Whether cells have these bodies.
inline bool is_of_cells(const Pavement& pavement) { return pavement.cell.form != CellForm::stone; }

// How far the patches of a cell with this outline may reach beyond it, mm: of a scale, by its tip.
double reach_of_cell_mm(const geometry::Polygon& outline, const CellShape& cell);

// The height of the filling between cells above their border: so that what is above it is `StoneSurface::height_mm` high.
double cell_bed_mm(const Pavement& pavement);
// That no cell exceeds.
double cell_top_mm(const Pavement& pavement);

}  // namespace shatterpave::paving
