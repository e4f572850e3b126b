// The square of grid points about the region is quartered; a quarter far from the border is taken or left whole.
#include "paving/tiles/near_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/corners.h"

namespace shatterpave::paving {

namespace {

// Small enough that few points are tested for nothing, large enough that few squares are.
constexpr std::int64_t smallest_square = 4;

struct Square {
  GridPoint low;
  std::int64_t size = 0;  // points on a side
};

struct Finder {
  const Grid& grid;
  const geometry::RegionIndex& area;
  double band_mm;
  std::vector<GridPoint> found;

  bool is_near(vec2 p) const { return area.contains(p) || area.border_within(p, band_mm); }

  void take(const Square& square, bool all) {
    for (std::int64_t j = square.low.j; j < square.low.j + square.size; ++j) {
      for (std::int64_t i = square.low.i; i < square.low.i + square.size; ++i) {
        if (all || is_near(grid.at(i, j))) found.push_back({j, i});
      }
    }
  }

  void visit(const Square& square) {
    const double half = 0.5 * static_cast<double>(square.size - 1);
    const vec2 centre = grid.at(square.low.i, square.low.j) + half * (grid.along + grid.across);
    const vec2 diagonal = half * (grid.along + grid.across);
    const double reach = std::sqrt(glm::dot(diagonal, diagonal)) + band_mm;
    if (!area.border_within(centre, reach)) {
      if (area.contains(centre)) take(square, true);
      return;
    }
    if (square.size <= smallest_square) {
      take(square, false);
      return;
    }
    const std::int64_t part = square.size / 2;
    for (const std::int64_t dj : {std::int64_t{0}, part}) {
      for (const std::int64_t di : {std::int64_t{0}, part}) visit({{square.low.j + dj, square.low.i + di}, part});
    }
  }
};

}  // namespace

std::vector<GridPoint> near_points(const Grid& grid, const geometry::RegionIndex& area, double band_mm) {
  const geometry::Box box = area.box();
  const std::array corners = geometry::corners(box);
  vec2 low{0.0, 0.0};
  vec2 high{0.0, 0.0};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const vec2 d = corners[k] - grid.origin;
    const vec2 index{glm::dot(d, grid.along) / glm::dot(grid.along, grid.along),
                     glm::dot(d, grid.across) / glm::dot(grid.across, grid.across)};
    low = k == 0 ? index : glm::min(low, index);
    high = k == 0 ? index : glm::max(high, index);
  }
  const double spacing = std::sqrt(std::min(glm::dot(grid.along, grid.along), glm::dot(grid.across, grid.across)));
  const auto margin = static_cast<std::int64_t>(std::ceil(band_mm / spacing)) + 1;
  const GridPoint first{std::llround(std::floor(low.y)) - margin, std::llround(std::floor(low.x)) - margin};
  const double points_across = std::max(high.x - low.x, high.y - low.y) + 2.0 * static_cast<double>(margin) + 2.0;
  std::int64_t size = smallest_square;
  while (static_cast<double>(size) < points_across) size *= 2;
  Finder finder{grid, area, band_mm, {}};
  finder.visit({first, size});
  std::ranges::sort(finder.found);
  return std::move(finder.found);
}

}  // namespace shatterpave::paving
