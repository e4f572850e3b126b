#include "paving/surface/laid_surface.h"

#include "paving/surface/wear.h"

namespace shatterpave::paving {

LaidSurface::LaidSurface(const Pavement& pavement, const std::vector<Stone>& stones, std::uint64_t seed,
                         std::optional<vec2> period_mm)
    : pavement_(pavement), stones_(stones), seed_(seed), period_mm_(period_mm), area_(pavement.area) {
  if (pavement.body.wear_mm == 0.0) return;
  traffic_ = period_mm ? std::vector<double>(stones.size(), 1.0) : paving::traffic(stones, area_);
}

StoneDraws LaidSurface::draws(std::size_t index) const {
  StoneDraws own = stone_draws(pavement_, seed_, stones_[index].id);
  own.sink_mm += stones_[index].sunk_mm;
  if (own.cell) own.cell->heading = stones_[index].angle.direction();
  return traffic_.empty() ? own : worn(own, pavement_, traffic_[index]);
}

std::vector<geometry::BezierPatch> LaidSurface::patches(std::size_t index, const StoneDraws& draws) const {
  const Stone& stone = stones_[index];
  auto patches = surface_patches(stone.outline_mm, draws, period_mm_ ? IsSawn{} : sawn_sides(stone, pavement_, area_));
  if (is_level()) return patches;
  const vec2 centre = geometry::centroid(stone.outline_mm);
  const GroundPoint below = ground(centre);
  for (geometry::BezierPatch& patch : patches) {
    for (vec3& p : patch.control_points) p.z += below.height_mm + glm::dot(below.slope, vec2{p.x, p.y} - centre);
  }
  return patches;
}

}  // namespace shatterpave::paving
