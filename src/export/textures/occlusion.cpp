#include "export/textures/occlusion.h"

#include <algorithm>

#include "core/error.h"
#include "export/shapes/stone_relief.h"

namespace shatterpave::exporting::textures {

namespace {

// By eye: joints are dark by what stands within three of their widths, or a third of a stone.
constexpr double joints_of_reach = 3.0;
constexpr double stones_of_reach = 0.3;

}  // namespace

std::size_t occlusion_reach(const paving::Pavement& pavement, const PixelGrid& grid) {
  const double reach_mm = std::max(joints_of_reach * pavement.joint_mm, stones_of_reach * shapes::mean_size_mm(pavement));
  return relief::horizon_reach(reach_mm / std::min(grid.pixel_mm.x, grid.pixel_mm.y));
}

void occlusion_row(const SurfaceMap& map, std::size_t row, std::span<float> open) {
  ENSURE(map.halo >= 1 && open.size() == map.grid.width);
  relief::occlusion_row(map.heights(), map.halo, row, open);
}

}  // namespace shatterpave::exporting::textures
