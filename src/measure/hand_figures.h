// What photographs of paving that was laid by hand are measured by: how widths of joints and sizes of stones differ.
#pragma once

#include <cstddef>

#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::measure {

// Widths: from three points of each long side of each stone of the field straight out to the next stone, where there is one
// within five joints. Sides: how far whole stones reach along their axis and across it, each over the mean of that way.
// Percentages of nothing are 0.
struct HandFigures {
  std::size_t widths = 0;
  double joint_median_percent = 0.0;  // of the asked width
  double joint_ln_spread = 0.0;       // standard deviation of ln(width)
  double narrowest_mm = 0.0;
  std::size_t stones = 0;            // whole ones of the field
  double side_spread_percent = 0.0;  // standard deviation over mean, of both ways together
  double aspect_median = 0.0;        // longer side over shorter one, of stones stretched to be as long as wide in the mean
  double aspect_p90 = 0.0;
};

// Of the stones as they lie.
HandFigures hand_figures(const paving::Pavement& pavement, const paving::StoneLayout& lying);

}  // namespace shatterpave::measure
