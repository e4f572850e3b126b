// Voronoi cells of points of the lattice, as polygons that share their corners.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::geometry {

struct Voronoi {
  std::vector<vec2> corners;                      // not on the lattice
  std::vector<std::vector<std::uint32_t>> cells;  // of each seed: its corners, counter-clockwise; none for unbounded cells

  Polygon outline(std::size_t cell) const;
};

//   seeds  on the lattice, distinct, within ±1 km
Voronoi voronoi(std::span<const vec2> seeds);

// Sorts the points by x, then y, and removes repeated ones.
void sort_distinct(std::vector<vec2>& points);

}  // namespace shatterpave::geometry
