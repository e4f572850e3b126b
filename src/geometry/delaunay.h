// The Delaunay triangulation of points of the lattice, as the neighbourhood of each point: a thin front over the Voronoi
// diagram of Boost.Polygon, which is exact on integers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/vec.h"

namespace shatterpave::geometry {

// Around each point, counter-clockwise: its neighbours, and the faces between one neighbour and the next. A face has three
// corners, or more where more than three points lie on one circle.
struct Delaunay {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  struct Spoke {
    std::uint32_t neighbour = none;
    std::uint32_t face = none;  // between this neighbour and the next; `none` outside the convex hull
  };

  std::vector<std::size_t> first;  // spokes of point i are [first[i], first[i + 1])
  std::vector<Spoke> spokes;
  std::size_t face_count = 0;

  std::size_t point_count() const { return first.size() - 1; }
  std::span<const Spoke> around(std::size_t point) const {
    return {spokes.data() + first[point], first[point + 1] - first[point]};
  }
};

// `points` lie on the lattice (they are rounded to it), are distinct, and within ±1 km.
Delaunay delaunay(std::span<const vec2> points);

}  // namespace shatterpave::geometry
