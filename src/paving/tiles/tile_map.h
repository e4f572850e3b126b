// Tiles as a map in the plane: points that neighbours share, and lines, along which sides of tiles follow one another.
#pragma once

#include <cstdint>
#include <vector>

#include "paving/tiles/tiling.h"

namespace shatterpave::paving {

// How a point of the map lies between the tiles about it.
enum class Junction {
  fixed,   // a corner of what the tiles cover together
  free,    // three or more tiles have a corner there, and no line goes on through it
  on_line  // a line goes on through it, on which others may end
};

struct TileMap {
  static constexpr std::uint32_t none = 0xffffffffU;

  // Sides of tiles that follow one another straight on, but for bends of less than 10°, from one end to the other.
  struct Line {
    std::vector<std::uint32_t> points;  // two or more, in order; of a closed line the first stands at the end, too
    bool closed = false;
    bool rim = false;      // the outline of what the tiles cover together
    double room_mm = 0.0;  // the least extent across it of the tiles beside it, those that are cut aside
  };
  // A point in the outline of a tile.
  struct Visit {
    std::uint32_t point = 0;
    std::uint32_t line = 0;  // of the side that begins here
    bool corner = true;      // whether the outline turns here
  };

  std::vector<vec2> points;                       // on the lattice
  std::vector<Junction> junctions;                // of each point
  std::vector<std::uint32_t> through;             // of a point on a line, that line; else `none`
  std::vector<std::vector<std::uint32_t>> stems;  // of each point, the other lines that end in it
  std::vector<double> room_mm;                    // of each point, the least extent of the tiles about it along their axes
  std::vector<Line> lines;
  std::vector<std::vector<Visit>> tiles;  // the outline of each tile, counter-clockwise, with all points that lie on it
};

// The tiles touch but do not overlap, but for rounding to the lattice: corners that lie within 3.5 µm of each other, or of a
// side, are taken to be one, or on that side.
TileMap tile_map(const std::vector<Tile>& tiles);

}  // namespace shatterpave::paving
