// Which stock stone each stone of a layout is cut from, so that they can be ordered.
#pragma once

#include <cstddef>
#include <vector>

#include "core/vec.h"

namespace shatterpave::paving {

// What a saw takes away between two pieces. A blade of 350 mm, as it is used on site, is 3.2 mm wide, and does not run quite
// true.
inline constexpr double saw_mm = 4.0;

// Where a rectangle lies on a stock stone.
struct Cut {
  std::size_t stock = 0;  // number of the stock stone, from 0 on
  vec2 low{0.0, 0.0};     // its lower left corner, mm from that of the stock stone
  bool turned = false;    // by a quarter: its length lies along the width of the stock stone
};

// Lays rectangles of `sizes_mm` on stock stones of `stock_mm`, each at least `saw_mm` from the next, so that straight cuts from
// side to side part them (guillotine cuts). The largest go first, each onto the smallest offcut that holds it, else onto a new
// stock stone. This takes time that hardly grows faster than their number; the plan need not be the best one: it is never worse
// than a stock stone for each.
//   REQUIRES every size > 0 and, laid as it is, within `stock_mm` but for 0.01 mm
std::vector<Cut> cutting_plan(const std::vector<vec2>& sizes_mm, vec2 stock_mm);

}  // namespace shatterpave::paving
