#include "export/textures/occlusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "export/shapes/stone_relief.h"

namespace shatterpave::exporting::textures {

namespace {

constexpr std::array<int, 10> distances = {1, 2, 3, 5, 8, 13, 21, 34, 55, 89};

struct Step {
  int x = 0;
  int y = 0;  // of rows, downwards
};
// Each direction and its opposite are looked into by different steps.
constexpr std::array<Step, 8> axes = {{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

// By eye: joints are dark by what stands within three of their widths, or a third of a stone.
constexpr double joints_of_reach = 3.0;
constexpr double stones_of_reach = 0.3;

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

std::size_t occlusion_reach(const paving::Pavement& pavement, const PixelGrid& grid) {
  const double reach_mm = std::max(joints_of_reach * pavement.joint_mm, stones_of_reach * shapes::mean_size_mm(pavement));
  const double pixels = reach_mm / std::min(grid.pixel_mm.x, grid.pixel_mm.y);
  int reach = distances.front();
  for (const int distance : distances) {
    if (distance <= pixels) reach = distance;
  }
  return static_cast<std::size_t>(reach);
}

void occlusion_row(const SurfaceMap& map, std::size_t row, std::span<float> open) {
  ENSURE(map.halo >= 1 && open.size() == map.grid.width);
  const auto length = static_cast<std::ptrdiff_t>(map.row_length());
  const float* here = &map.height_mm[map.index(0, row)];
  const vec2 pixel = map.grid.pixel_mm;
  std::ranges::fill(open, 0.0F);
  std::vector<float> horizon(open.size());
  for (const Step& axis : axes) {
    std::ranges::fill(horizon, 0.0F);
    for (const int distance : distances) {
      if (distance > static_cast<int>(map.halo)) break;
      const Step step = step_of(axis, distance);
      const double mm = std::sqrt(step.x * step.x * pixel.x * pixel.x + step.y * step.y * pixel.y * pixel.y);
      raise_horizon(here, here + step.y * length + step.x, static_cast<float>(1.0 / mm), horizon);
    }
    for (std::size_t x = 0; x < open.size(); ++x) open[x] += 0.125F / (1.0F + horizon[x] * horizon[x]);
  }
}

}  // namespace shatterpave::exporting::textures
