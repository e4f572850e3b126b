// The figures of a pane that photograph, paper and generated panes have in common: all are measured on polylines, whatever they
// came from.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "glass/network.h"
#include "glass/pane.h"
#include "measure/distribution.h"

namespace shatterpave::measure {

// Of the first impact.
struct PaneFigures {
  int radial_count = 0;                 // M, as drawn or as counted near the impact
  int reaching_count = 0;               // N: radials that end on the edge
  int ring_count = 0;                   // pieces of rings: of two arms with one starting point, one
  Distribution ring_mm;                 // d_i: distances of the feature points of rings from the impact
  Distribution turn_deg;                // θ_i along radials that reach the edge
  double turn_correlation = 0.0;        // of a turn with the one before it, about 0; 0 where there are fewer than ten pairs
  std::optional<double> gap_variation;  // SD over mean of the angles between neighbouring radials, on a circle of a fifth of
                                        // the root of the pane's area; nothing where fewer than three reach it
  double branches_per_m = 0.0;          // branches over the length of radials that reach the edge
  Distribution piece_mm2;               // areas of the pieces that cracks cut out, of 1 mm² and more
  double median_piece_mm2 = 0.0;
  double median_elongation = 0.0;  // of pieces of 10 mm² and more, that the edge does not bound
};

// `network`, which has an impact, is that of the pane.
PaneFigures pane_figures(const glass::CrackNetwork& network, const glass::Pane& pane);

// The pieces in each whole square of 50 × 50 mm of a grid from the lower left corner of the pane's box: a piece within counts
// one, one that the square's border cuts a half, as EN 12150-1 counts them, but without its margins, for which small panes have
// no room.
std::vector<double> pieces_per_square(const glass::CrackNetwork& network, const glass::Pane& pane);

// The figures as numbers, for statistics of many panes: M, N, rings, mean and SD of d, SD and correlation of θ, gap variation,
// branches. What was not measured is 0.
inline constexpr std::size_t figure_count = 9;
inline constexpr std::array<std::string_view, figure_count> figure_names = {
    "radial_count", "reaching_count",   "ring_count",    "ring_mean_mm",  "ring_sd_mm",
    "turn_sd_deg",  "turn_correlation", "gap_variation", "branches_per_m"};
std::array<double, figure_count> numbers_of(const PaneFigures& figures);

}  // namespace shatterpave::measure
