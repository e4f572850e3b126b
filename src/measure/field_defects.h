// The irregular spots that a direction field forces upon a packing of squares, however well it is packed.
//
// Let the rows run along the unit vector t, and the columns along n, t turned to the left; a and b are the pitches along the
// rows and across them. On a step dx one crosses t·dx / a columns and n·dx / b rows. Where stones are regular, both counts come
// to nought on the way round any closed line. By Green's theorem the way round a small area dA adds up to
//
//   (curl t / a) dA columns  and  (curl n / b) dA = (div t / b) dA rows;
//
// as many must end there: it is the density of Burgers vectors of the dislocations that a bent lattice needs (J. F. Nye, "Some
// geometrical relations in dislocated crystals", Acta Metallurgica 1, 1953). With the field at angle θ, curl t = t·∇θ is the
// curvature of the rows, and div t = n·∇θ that of the columns. Columns that end cannot make good for others that begin
// elsewhere, so that the least number of ends, with all stones and joints as asked, is
//
//   ∫ (|curvature of rows| / a + |curvature of columns| / b) dA.
//
// For circles about a centre, curl t = 1 / r and div t = 0: a quarter annulus of radii R and S needs (π / 2) (S − R) / a, which
// for 4 and 10 is 9.42 / a. A packing may do with fewer where it stretches joints and stones, or sets the ends against a
// border.
//
// Where sizes s follow a field, a and b are s times what they are elsewhere, and t / s and n / s stand in place of t and n:
// rows of larger stones have fewer columns.
//
// Where a cross field turns by quarter turns about a point (half turns, for oblong stones), a singularity, there is one spot
// more: a stone, or a corner, with three or five sides for each quarter turn.
#pragma once

#include <cstddef>

#include "geometry/region_index.h"
#include "paving/field/direction_field.h"
#include "paving/field/size_field.h"
#include "paving/pavement.h"

namespace shatterpave::measure {

struct FieldDefects {
  double row_bends = 0.0;         // columns that must end, from the curvature of rows
  double column_bends = 0.0;      // rows that must end
  std::size_t singularities = 0;  // quarter turns of the field about its singular points, within the area

  double least_spots() const { return row_bends + column_bends + static_cast<double>(singularities); }
};

// Summed over small squares within the area, by the way round each. `field`, `sizes` and `area` are those of the pavement.
FieldDefects field_defects(const paving::Pavement& pavement, const paving::DirectionField& field,
                           const paving::SizeField& sizes, const geometry::RegionIndex& area);

}  // namespace shatterpave::measure
