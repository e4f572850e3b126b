#include "relief/surface_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shatterpave::relief {

namespace {

constexpr std::array<int, 10> distances = {1, 2, 3, 5, 8, 13, 21, 34, 55, 89};

struct Step {
  int x = 0;
  int y = 0;  // of rows, downwards
};
// Each direction and its opposite are looked into by different steps.
constexpr std::array<Step, 8> axes = {{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

// The pixel nearest to that distance along an axis, so that diagonals reach no farther.
Step step_of(const Step& axis, int distance) {
  constexpr double half_root = 0.70710678118654752;
  if (axis.x == 0 || axis.y == 0) return {axis.x * distance, axis.y * distance};
  const int part = std::max(1, static_cast<int>(std::lround(half_root * distance)));
  return {axis.x * part, axis.y * part};
}

// Raises the slopes of the horizon to what stands at `step` from each pixel of `here`.
void raise_horizon(const float* here, const float* there, float per_mm, std::span<float> horizon) {
  for (std::size_t x = 0; x < horizon.size(); ++x) horizon[x] = std::max(horizon[x], (there[x] - here[x]) * per_mm);
}

}  // namespace

void normal_row(const HeightRows& heights, std::size_t row, std::span<float> values) {
  const auto length = static_cast<std::ptrdiff_t>(heights.row_length);
  const float* here = heights.row(row);
  const auto half_x = static_cast<float>(0.5 / heights.pixel_mm.x);
  const auto half_y = static_cast<float>(0.5 / heights.pixel_mm.y);
  for (std::size_t column = 0; column < values.size() / 3; ++column) {
    const float* at = here + column;
    const float x = (at[-1] - at[1]) * half_x;
    const float y = (at[length] - at[-length]) * half_y;  // rows go down, y up
    const float half = 0.5F / std::sqrt(x * x + y * y + 1.0F);
    values[3 * column] = 0.5F + half * x;
    values[3 * column + 1] = 0.5F + half * y;
    values[3 * column + 2] = 0.5F + half;
  }
}

std::size_t horizon_reach(double pixels) {
  int reach = distances.front();
  for (const int distance : distances) {
    if (distance <= pixels) reach = distance;
  }
  return static_cast<std::size_t>(reach);
}

void occlusion_row(const HeightRows& heights, std::size_t reach, std::size_t row, std::span<float> open) {
  const auto length = static_cast<std::ptrdiff_t>(heights.row_length);
  const float* here = heights.row(row);
  const vec2 pixel = heights.pixel_mm;
  std::ranges::fill(open, 0.0F);
  std::vector<float> horizon(open.size());
  for (const Step& axis : axes) {
    std::ranges::fill(horizon, 0.0F);
    for (const int distance : distances) {
      if (distance > static_cast<int>(reach)) break;
      const Step step = step_of(axis, distance);
      const double mm = std::sqrt(step.x * step.x * pixel.x * pixel.x + step.y * step.y * pixel.y * pixel.y);
      raise_horizon(here, here + step.y * length + step.x, static_cast<float>(1.0 / mm), horizon);
    }
    for (std::size_t x = 0; x < open.size(); ++x) open[x] += 0.125F / (1.0F + horizon[x] * horizon[x]);
  }
}

}  // namespace shatterpave::relief
