// How large stones are beside the stock that they are cut from.
#pragma once

#include <optional>
#include <vector>

#include "geometry/polygon.h"
#include "paving/pavement.h"

namespace shatterpave::measure {

struct StockLimit {
  std::vector<vec2> faces_mm;  // length and width; a stone is cut from one of these
  double area_mm2 = 0.0;       // of the largest
  // How many times as long, as wide and as large as its stock a stone may be; nothing where the bond has no limit.
  std::optional<double> most;
};

// Of the stones of the bond, by what docs/bonds.md says of `stone_mm`: made by other formulas than the bonds' own
// (paving/bonds), so that it judges them.
StockLimit stock_limit(const paving::Pavement& pavement);
// Of the stones of the border course, if there is one.
StockLimit border_stock_limit(const paving::Pavement& pavement);

// A stone over its stock, at the rotation and beside the face at which it comes nearest to fitting: the greater of length and
// width is least.
struct StockShare {
  double length = 0.0;
  double width = 0.0;
  double area = 0.0;
};
StockShare stock_share(const geometry::Polygon& stone, const StockLimit& stock);

}  // namespace shatterpave::measure
