#include "paving/tiles/pattern.h"

#include <algorithm>
#include <cmath>

#include "geometry/lattice.h"
#include "paving/tiles/near_points.h"

namespace shatterpave::paving {

namespace {

// How far the tiles of one period reach from its origin, mm.
double reach(const Pattern& pattern) {
  double farthest = 0.0;
  for (const Tile& tile : pattern.tiles) {
    for (const vec2& p : tile.outline_mm) farthest = std::max(farthest, glm::dot(p, p));
  }
  return std::sqrt(farthest) + (pattern.shift == 0.0 ? 0.0 : pattern.period_mm.x);
}

Tile placed(const Tile& tile, vec2 by, const Placement& placement) {
  Tile result;
  result.outline_mm.reserve(tile.outline_mm.size());
  for (const vec2& p : tile.outline_mm) result.outline_mm.push_back(geometry::on_lattice(placement.out_of(by + p)));
  result.axis = tile.axis.x * placement.along + tile.axis.y * left_of(placement.along);
  return result;
}

}  // namespace

vec2 lowest_corner(const geometry::RegionIndex& area, vec2 along) {
  const vec2 across = left_of(along);
  vec2 low{0.0, 0.0};
  for (std::size_t i = 0; i < area.segments().size(); ++i) {
    const vec2 p = area.segments()[i].from;
    const vec2 turned{glm::dot(p, along), glm::dot(p, across)};
    low = i == 0 ? turned : glm::min(low, turned);
  }
  return low;
}

Placement anchored(const geometry::RegionIndex& area, vec2 along) {
  const vec2 low = lowest_corner(area, along);
  return {low.x * along + low.y * left_of(along), along};
}

bool is_needed(const geometry::Polygon& outline, const geometry::RegionIndex& area) {
  return area.border_meets(geometry::bounding_box(outline)) || area.contains(outline.front());
}

std::vector<Tile> repeated(const Pattern& pattern, const Placement& placement, const geometry::RegionIndex& area) {
  const vec2 row = placement.direction_of(pattern.row);
  const Grid grid{placement.origin, pattern.period_mm.x * row, pattern.period_mm.y * left_of(row)};
  std::vector<Tile> tiles;
  for (const GridPoint& p : near_points(grid, area, reach(pattern))) {
    const double moved = static_cast<double>(p.j) * pattern.shift;
    const double along = (static_cast<double>(p.i) + moved - std::floor(moved)) * pattern.period_mm.x;
    const double across = static_cast<double>(p.j) * pattern.period_mm.y;
    const vec2 by = along * pattern.row + across * left_of(pattern.row);
    for (const Tile& tile : pattern.tiles) {
      Tile one = placed(tile, by, placement);
      if (is_needed(one.outline_mm, area)) tiles.push_back(std::move(one));
    }
  }
  return tiles;
}

}  // namespace shatterpave::paving
