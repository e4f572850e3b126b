#include "render/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace shatterpave::render_tests {

namespace {

struct Window {
  std::size_t left = 0;
  std::size_t top = 0;
  std::size_t right = 0;   // one past
  std::size_t bottom = 0;  // one past
};

struct Channel {
  const relief::Raster& picture;
  std::size_t index;

  double at(std::size_t x, std::size_t y) const {
    return static_cast<double>(picture.values[(y * picture.width + x) * picture.channels + index]);
  }
};

std::vector<double> sorted_values(const Channel& channel, const Window& window) {
  std::vector<double> values;
  for (std::size_t y = window.top; y < window.bottom; ++y) {
    for (std::size_t x = window.left; x < window.right; ++x) values.push_back(channel.at(x, y));
  }
  std::ranges::sort(values);
  return values;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values, double mean) {
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double percentile_of(const std::vector<double>& sorted, double percent) {
  const double rank = std::ceil(percent / 100.0 * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

double gradient_of(const Channel& channel, const Window& window) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t y = window.top; y + 1 < window.bottom; ++y) {
    for (std::size_t x = window.left; x + 1 < window.right; ++x) {
      const double right = channel.at(x + 1, y) - channel.at(x, y);
      const double down = channel.at(x, y + 1) - channel.at(x, y);
      sum += right * right + down * down;
      ++count;
    }
  }
  return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

void append(std::vector<Statistic>& all, const relief::Raster& shown, const std::string& region, const Window& window) {
  for (std::size_t index = 0; index < 3; ++index) {
    const Channel channel{shown, index};
    const std::vector<double> values = sorted_values(channel, window);
    const double mean = mean_of(values);
    const std::array<double, measure_names.size()> results = {mean,
                                                              deviation_of(values, mean),
                                                              percentile_of(values, 5),
                                                              percentile_of(values, 25),
                                                              percentile_of(values, 50),
                                                              percentile_of(values, 75),
                                                              percentile_of(values, 95),
                                                              gradient_of(channel, window)};
    for (std::size_t i = 0; i < results.size(); ++i) all.push_back({region, "RGB"[index], static_cast<Measure>(i), results[i]});
  }
}

}  // namespace

std::vector<Statistic> statistics(const relief::Raster& linear, Grid grid) {
  ENSURE(linear.channels >= 3 && grid.columns >= 1 && grid.rows >= 1);
  ENSURE(linear.width >= grid.columns && linear.height >= grid.rows);
  const relief::Raster shown = relief::display(linear);
  std::vector<Statistic> all;
  append(all, shown, "whole", {0, 0, shown.width, shown.height});
  for (std::size_t row = 0; row < grid.rows; ++row) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      append(all, shown, fmt::format("row {}, column {}", row, column),
             {column * shown.width / grid.columns, row * shown.height / grid.rows, (column + 1) * shown.width / grid.columns,
              (row + 1) * shown.height / grid.rows});
    }
  }
  return all;
}

}  // namespace shatterpave::render_tests
