// Tiles that fill a region: cut where they lie over one another or over the border, with what they leave as tiles of its own.
#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "paving/tiles/tiling.h"

namespace shatterpave::paving {

// `tiles`, which may lie over one another and reach beyond `region` in any way, as tiles that fill it: an earlier one keeps
// what two have in common. What none covers are tiles at the end, of any size and shape, along the tile that they share most
// of their border with. By construction no two overlap and nothing stays bare, but for the rounding of corners to the lattice
// (geometry/overlay.h): a side strays by less than 2 µm.
std::vector<Tile> filling_tiles(const std::vector<Tile>& tiles, const geometry::Region& region);

// Only those that are at the end of `filling_tiles`.
std::vector<Tile> gap_tiles(const std::vector<Tile>& tiles, const geometry::Region& region);

// The region as polygons without holes: it is cut through the middle of each hole. About a hole that is 1 µm wide or tall, 1 µm
// more is left out.
std::vector<geometry::Polygon> without_holes(geometry::Region region);

}  // namespace shatterpave::paving
