// Statistics of a picture, by which two pictures are compared that need not agree in every pixel.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "relief/raster.h"

namespace shatterpave::render_tests {

enum class Measure { mean, deviation, percentile_5, percentile_25, percentile_50, percentile_75, percentile_95, gradient };

inline constexpr std::array<std::string_view, 8> measure_names = {"mean", "deviation", "p05", "p25",
                                                                  "p50",  "p75",       "p95", "gradient"};

struct Statistic {
  std::string region;  // "whole", or "row 0, column 2" of the grid, from the top left
  char channel = 'R';
  Measure measure = Measure::mean;
  double value = 0.0;
};

struct Grid {
  std::size_t columns = 4;
  std::size_t rows = 4;
};

// The statistics of `linear`, which has three channels, of the whole and of each region of the grid, in an order that
// depends on the grid alone. They are taken of the picture as a screen shows it (relief::display), 0 … 1, so that a highlight
// a hundred times as bright as white weighs no more than the eye gives it.
//   deviation    standard deviation
//   percentile   by the nearest rank
//   gradient     root of the mean of the squared differences to the right and to the lower neighbour
std::vector<Statistic> statistics(const relief::Raster& linear, Grid grid);

}  // namespace shatterpave::render_tests
