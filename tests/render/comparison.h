// Two pictures, or two series of pictures, compared by their statistics.
#pragma once

#include <string>
#include <vector>

#include "relief/raster.h"
#include "render/case.h"

namespace shatterpave::render_tests {

struct Row {
  std::string what;  // region, channel and measure
  double golden = 0.0;
  double now = 0.0;
  double limit = 0.0;  // of |now - golden|
  double excess() const;
};

struct Comparison {
  std::vector<Row> rows;
  bool agrees() const;
  // As text: first what is out of tolerance, the worst first, then the rest.
  std::string table() const;
};

// One picture with one, by the tolerances of the case. Throws std::runtime_error where their sizes differ.
Comparison compared(const Case& expected, const relief::Raster& golden, const relief::Raster& now);

// Pictures of many seeds with those of as many others: mean and spread of the statistics of the whole picture.
Comparison compared_over_seeds(const Case& expected, const std::vector<relief::Raster>& golden,
                               const std::vector<relief::Raster>& now);

// Half of the difference, grey where the two agree: linear, so that it can be written as they are.
relief::Raster difference(const relief::Raster& golden, const relief::Raster& now);

}  // namespace shatterpave::render_tests
