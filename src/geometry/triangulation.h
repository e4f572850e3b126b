// Regions as triangles. Exact: every decision is made in integers, so any region, however thin, is divided correctly.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/polygon.h"

namespace shatterpave::geometry {

// Three of the vertices, counter-clockwise.
using TriangleCorners = std::array<std::size_t, 3>;

// Triangles that tile the region: n + 2 h − 2 of them, where its rings have n vertices and h of them are holes; none is without
// area.
//   rings  the outline, counter-clockwise, and the holes, clockwise; they touch neither themselves nor one another
// Corners count through all vertices, ring after ring. Ears are cut off one by one, in O(n²) for usual regions.
std::vector<TriangleCorners> triangulation(std::span<const std::vector<LatticePoint>> rings);

// The rings of a region, on the lattice.
std::vector<std::vector<LatticePoint>> lattice_rings(const Region& region);

}  // namespace shatterpave::geometry
