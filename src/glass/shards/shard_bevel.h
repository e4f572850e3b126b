// A side of a shard, front or back: the flat face, and the bevel that leads from its border up to it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/polygon.h"
#include "glass/shards/shards.h"

namespace shatterpave::glass {

struct ShardBlank;

// Triangles over the plan of a shard, counter-clockwise in it, each with a height above the border at its corners. They tile
// the plan, so that the side closes whatever its heights are.
struct ShardSide {
  struct Vertex {
    geometry::LatticePoint plan;
    std::int64_t rise_um = 0;  // above the border: 0 … the depth of the bevel

    bool operator==(const Vertex&) const = default;
  };
  struct Triangle {
    std::array<std::size_t, 3> corners{};  // those of the border first, ring after ring, then those of `vertices`
    ShardSurface surface = ShardSurface::old;

    bool operator==(const Triangle&) const = default;
  };
  std::vector<Vertex> vertices;  // but those of the border
  std::vector<Triangle> triangles;

  bool operator==(const ShardSide&) const = default;
};

// A side without a bevel: all of it lies in the face of the pane.
ShardSide sharp_side(const ShardBlank& blank);

// A side whose flat parts are `flats`, which lie strictly within the blank and touch neither it nor one another; at least one.
//
// Guarantees:
// 1. Every triangle that is level lies in the face of the pane and is old; but for what is narrower than 8 µm, and where three
//    ridges of one height meet.
// 2. A triangle of the bevel that has a side of the border is of the surface of the wall there, unless that is a stub; another
//    one is of that of the nearest wall at its corners, and one at a ridge, or farther from these than the bevel is wide, of
//    that of the nearest of all. So bevels along the pane's old edge are old, along cracks broken. What leads farther in from
//    the old edge than a bevel is of a chip, and broken.
// 3. Where there is no flat part between two walls, their bevels meet in a ridge, as high as it is far from the nearest of
//    them.
//   depth_um > 0, of the bevel
ShardSide bevelled_side(const ShardBlank& blank, const std::vector<geometry::Region>& flats, std::int64_t depth_um);

}  // namespace shatterpave::glass
