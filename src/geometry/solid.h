// Closed solids as meshes of triangles, on the lattice in three dimensions.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.h"
#include "geometry/lattice.h"

namespace shatterpave::geometry {

struct LatticePoint3 {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t z = 0;

  auto operator<=>(const LatticePoint3&) const = default;
};

// Corners are seen counter-clockwise from outside.
struct SolidTriangle {
  std::array<std::uint32_t, 3> corners{};
  int slot = 0;  // whatever the caller wants to know it by

  bool operator==(const SolidTriangle&) const = default;
};

struct Solid {
  std::vector<LatticePoint3> vertices;
  std::vector<SolidTriangle> triangles;

  bool operator==(const Solid&) const = default;
};

// Six times the volume, which is a whole number of µm³ and positive where the solid is right side out.
//   REQUIRES  extents of at most 1 km, so that no sum passes the bounds of 128 bits
__extension__ using WideVolume = __int128;
WideVolume sextuple_volume(const Solid& solid);

// The unit normal of a triangle, outwards.
//   REQUIRES  it has an area
vec3 normal(const Solid& solid, const SolidTriangle& triangle);

// Whether every edge of a triangle is that of one other triangle in the opposite direction, so that the surface is closed and
// oriented. No edge stands more than once in one direction.
bool is_closed(const Solid& solid);

}  // namespace shatterpave::geometry
