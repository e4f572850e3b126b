// Pictures as tracing sees them: grey levels, and where their pixels lie on the pane.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/vec.h"

namespace shatterpave::trace {

// Rows from the top. Places in it are in px, x right and y down; the middle of the first pixel is (0.5, 0.5).
template <typename Value>
struct Grid {
  int width = 0;
  int height = 0;
  std::vector<Value> values;  // width * height

  Grid() = default;
  Grid(int columns, int rows, Value value = Value{})
      : width(columns), height(rows), values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), value) {}

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  Value& at(int x, int y) { return values[index(x, y)]; }
  const Value& at(int x, int y) const { return values[index(x, y)]; }
  bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  // The value of the pixel that holds `p`; of the nearest one, outside.
  const Value& nearest(vec2 p) const;

  bool operator==(const Grid&) const = default;
};

using Grey = Grid<std::uint8_t>;  // levels 0 … 255
using Mask = Grid<std::uint8_t>;  // 1: part of a line; 0: not

// The corners of a pane in a photograph: upper left, upper right, lower right, lower left, as seen; px.
using Corners = std::array<vec2, 4>;

// A map of the plane that keeps straight lines straight, by its 3 × 3 matrix, row by row.
struct Perspective {
  std::array<double, 9> rows{1, 0, 0, 0, 1, 0, 0, 0, 1};

  vec2 operator()(vec2 p) const;
};

// The one that takes the corners of the picture of that size to `corners`, by OpenCV.
Perspective perspective_to(const Corners& corners, double width, double height);

// The pane alone, seen from straight ahead.
struct Sight {
  Grey picture;
  Perspective to_photograph;  // from px of `picture`
  double mm_per_px = 1.0;     // of `picture`
};

// The pane of size `pane_mm` whose corners are given: about as many pixels as the photograph has of it, at most `longest_side`
// px on a side. A smaller picture is the mean of what it takes the place of.
Sight seen_straight(const Grey& photograph, const Corners& corners, vec2 pane_mm, int longest_side);

// The mean of 3 × 3 pixels, rounded; at the border of those that are there (Agui et al. 1992, §3.1.2).
Grey mean_of_nine(const Grey& picture);

// The standard deviation of noise from pixel to pixel, in levels: from the median of what a mask that no plane or step along
// the axes shows in gives (J. Immerkær, "Fast noise variance estimation", CVIU 64, 1996; its mean counts lines as noise).
double noise_deviation(const Grey& picture);

template <typename Value>
const Value& Grid<Value>::nearest(vec2 p) const {
  const auto within = [](double value, int count) {
    if (!(value > 0.0)) return 0;
    return value >= static_cast<double>(count) ? count - 1 : static_cast<int>(value);
  };
  return at(within(p.x, width), within(p.y, height));
}

}  // namespace shatterpave::trace
