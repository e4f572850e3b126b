// What is measured on the stones of a pavement: what a good paviour would look at.
//
// Alignment: the angle between a side of a whole stone and the nearest of what the bond asks of its sides, along the rows or
// across them, 0 … 45°, weighted by the length of sides. What is asked is
//   packed                                   the direction field, at the middle of the side
//   running, stack                           with a constant direction, and on circles, the same; along a boundary or guides,
//                                            whose rows are parallel lines, the stone's own `angle`
//   other bonds of square stones             the main direction and the turn of the pattern
//   bonds of others (hexagon, fan …)         nothing of the kind: not measured
//   stones of the border course              the stone's own `angle`
// Four-sided: of the bonds that are measured for alignment, the whole stones with four corners.
// Joints: from a point of each side of a whole stone straight out to the next stone, if there is one within three joints; over
// the asked width. Where a row or a column ends, joints cannot all be as asked: those beside an irregular stone are excepted,
// and counted. (Stones that follow a bend without such an end share their cell's sides, so that no bend needs more.)
// Bare spot: of the stones grown by half a joint, with the half joint along the border taken off (measure/bare_spot.h).
// Stock: every stone beside what its bond, or its border course, cuts stones from (measure/stone_stock.h).
// Areas: of whole stones, but for bonds whose stones differ by design. Which these are, and which have square stones, is told
// in the table of bonds (paving/bonds/table.h). Regular: in a packing, a stone with four neighbours. Of stones that have no cut
// one and no border beside them the others are counted, and the spots that those side by side make. One spot is the end of at
// least one row or column; measure/field_defects.h tells the least number that the field allows.
//
// Of a packing, what tells organic textures apart besides: measure/cell_figures.h.
//
// What [pavement.variation] asks for is no fault: stones missing, turned, moved and of other sizes. So faults are looked for
// among the stones as they lie, and all else is measured on the stones as they were set out, before variation. So it is with
// stones laid by hand, of which what photographs measure is told besides, as they lie (measure/hand_figures.h).
#pragma once

#include <optional>
#include <vector>

#include "measure/cell_figures.h"
#include "measure/distribution.h"
#include "measure/field_defects.h"
#include "measure/hand_figures.h"
#include "measure/layout_faults.h"
#include "measure/stone_stock.h"
#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::measure {

// Of one stone, as set out.
struct StoneMeasures {
  int id = 0;
  paving::StoneKind kind = paving::StoneKind::whole;
  bool in_border_course = false;
  vec2 middle_mm{0.0, 0.0};
  std::size_t corners = 0;
  std::optional<int> neighbours;         // sides shared with other stones; of a whole stone of a packing
  bool irregular = false;                // one of the irregular stones
  double area_ratio = 0.0;               // over that of the stone that is asked for there
  StockShare stock;                      // how large beside what it is cut from
  std::optional<double> misaligned_deg;  // mean over its sides by length; of a whole stone
  Distribution joint_ratio;              // of the joints beside it; of a whole stone
  bool missing = false;                  // left out by variation
};

// Of all stones of a layout. Percentages of nothing are 0.
struct LayoutFigures {
  std::size_t stones = 0;  // as set out
  std::size_t whole = 0;
  std::size_t missing = 0;
  LayoutFaults faults;

  std::size_t sides = 0;  // that alignment is measured on
  double misaligned_mean_deg = 0.0;
  double misaligned_p95_deg = 0.0;
  std::size_t shaped = 0;  // whole stones that should have four sides
  double four_sided_percent = 0.0;

  double covered_percent = 0.0;
  std::size_t holes = 0;
  double bare_spot_mm = 0.0;  // diameter of the widest disc between stones that are grown by half a joint

  std::size_t joints = 0;
  std::size_t excepted_joints = 0;
  double joint_p5_percent = 0.0;  // of the asked width; over the joints that are not excepted
  double joint_median_percent = 0.0;
  double joint_p95_percent = 0.0;

  std::size_t sized = 0;  // whole stones that should be of one size
  double area_mean_percent = 0.0;
  double area_spread_percent = 0.0;  // standard deviation over mean
  double smallest_percent = 0.0;     // least area of a stone over that of the asked one

  double largest_length_percent = 0.0;  // of the stock that a stone is cut from; of all stones
  double largest_width_percent = 0.0;
  double largest_area_percent = 0.0;
  std::size_t limited = 0;               // stones of a bond or a border course whose stones have a limit
  double largest_limited_percent = 0.0;  // length, width or area of one of those over its limit

  std::size_t counted_stones = 0;  // that are looked at for regularity
  std::size_t irregular_stones = 0;
  std::size_t irregular_spots = 0;
  FieldDefects field;  // of a packing

  CellFigures cells;  // of a packing

  HandFigures hand;  // of stones laid by hand, as they lie; else of nothing
};

struct LayoutMeasures {
  LayoutFigures figures;
  std::vector<StoneMeasures> stones;                                   // as set out
  std::vector<vec2> holes_mm;                                          // where a stone is missing that should not be
  vec2 bare_spot_mm{0.0, 0.0};                                         // middle of the widest, if there is one
  Histogram misaligned_deg{0.0, 0.25, std::vector<std::size_t>(60)};   // of sides; 0 … 15°
  Histogram joints_percent{48.75, 2.5, std::vector<std::size_t>(40)};  // about 50 … 150 %, one cell about 100
  Histogram areas_percent{48.75, 2.5, std::vector<std::size_t>(40)};   // of whole stones that should be of one size
};

// `set_out` is the layout without variation, `lying` the one with it; the same where none is asked. Time goes with the number
// of stones.
LayoutMeasures measured(const paving::Pavement& pavement, const paving::StoneLayout& set_out, const paving::StoneLayout& lying);

}  // namespace shatterpave::measure
