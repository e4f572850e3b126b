#include "paving/surface/wear.h"

#include <algorithm>

#include "core/parallel.h"
#include "core/smooth_step.h"

namespace shatterpave::paving {

std::vector<double> traffic(const std::vector<Stone>& stones, const geometry::RegionIndex& area) {
  std::vector<double> distances(stones.size());
  parallel_for(stones.size(),
               [&](std::size_t s) { distances[s] = area.nearest(geometry::centroid(stones[s].outline_mm)).distance_mm; });
  const double farthest = distances.empty() ? 0.0 : *std::ranges::max_element(distances);
  if (farthest == 0.0) return std::vector<double>(distances.size(), 0.0);
  for (double& distance : distances) distance = smooth_step(distance / farthest);
  return distances;
}

IsSawn sawn_sides(const Stone& stone, const Pavement& pavement, const geometry::RegionIndex& area) {
  if (stone.kind != StoneKind::cut) return {};
  // Half a joint from the border, moved by up to another half; a millimetre for corners left out.
  const double near_mm = pavement.joint_mm + 1.0;
  return [near_mm, &area](vec2 a, vec2 b) {
    return area.border_within(a, near_mm) && area.border_within(0.5 * (a + b), near_mm) && area.border_within(b, near_mm);
  };
}

}  // namespace shatterpave::paving
