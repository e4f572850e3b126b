// What the cells of a packing measure, as cells of tissues and skins are measured: neighbours, areas, and how well they line up
// with the field.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/polygon.h"
#include "paving/field/direction_field.h"

namespace shatterpave::measure {

// A cell that has neighbours all round.
struct InnerCell {
  const geometry::Polygon* outline_mm = nullptr;  // not null
  int neighbours = 0;                             // sides shared with other cells
};

// Percentages and means of nothing are 0.
struct CellFigures {
  std::size_t counted = 0;
  double neighbours_mean = 0.0;
  double four_percent = 0.0;  // of the cells, those with four neighbours
  double five_percent = 0.0;
  double six_percent = 0.0;
  double area_median_mm2 = 0.0;
  double area_ln_spread = 0.0;  // standard deviation of ln(area): 0 where all are alike, whatever their size
  // Mean of cos 4α over the sides of all cells, by length, with α from the field's axis to the side: 1 where all sides lie
  // along the field or across it, 0 where they lie any way, −1 where all lie at 45° to it. It is the order parameter ψ4 of
  // square lattices, with the field in place of the mean axis.
  double order = 0.0;
};

CellFigures cell_figures(std::span<const InnerCell> cells, const paving::DirectionField& field);

}  // namespace shatterpave::measure
