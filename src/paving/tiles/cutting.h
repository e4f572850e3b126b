// From cells to stones: cut at the outline and holes, small pieces joined to their neighbours, and the joint taken off.
#pragma once

#include <vector>

#include "geometry/region_index.h"
#include "paving/pavement.h"
#include "paving/stones.h"
#include "paving/tiles/cells.h"
#include "paving/tiles/stock.h"

namespace shatterpave::paving {

// The least part of a whole stone's face that is laid as a stone of its own, where it has a neighbour to be joined to.
// Source: design target of this project; paviours' guides ask for a quarter to a third of a sett at the least.
inline constexpr double least_piece = 0.25;

// A cell, or what is left of it, before the joint is taken off.
struct Piece {
  geometry::Polygon outline_mm;  // counter-clockwise, simple
  std::uint32_t cell = 0;        // the cell it is of, or the largest of those
  bool cut = false;              // the outline or a hole took part of it, or it was joined
  vec2 axis{1.0, 0.0};           // unit vector along its stone
  double size = 1.0;             // of its stone, as a part of the one that is asked for
};

// What pieces are measured by: of a stone of size 1. Each piece is held against its own stone.
struct StoneSize {
  double whole_face_mm2 = 0.0;
  double longer_mm = 0.0;  // the longer side of the stone that is asked for
  double joint_mm = 0.0;
  Stock stock;  // no stone is larger
  // A piece that lost no more of its cell than this is whole: cells that were set out along the border end there but for
  // rounding.
  double rounding_mm2 = -1.0;

  // Of stones that are larger or smaller by this factor each way, with the same joint.
  StoneSize times(double factor) const {
    return {factor * factor * whole_face_mm2, factor * longer_mm, joint_mm, stock.times(factor), rounding_mm2};
  }
};

// The pieces of the cells within `region`, of which `index` is made. Each can be cut from the stock once the joint is taken
// off, but for slight bends (`laid_faces` trims those). None is small that can be joined to a neighbour, or cut anew with one
// in halves, so that the stones still fit the stock.
std::vector<Piece> pieces_within(const Cells& cells, const geometry::Region& region, const geometry::RegionIndex& index,
                                 const StoneSize& size);

// The piece's face: its outline moved in by half the joint. Empty if nothing is left; several where it falls apart.
std::vector<geometry::Polygon> faces_of(const geometry::Polygon& piece, double joint_mm);

// The widest disc that may stay bare between stones grown by half a joint, as a part of the longer side of a stone.
inline constexpr double widest_bare = 0.1;

// What a piece has that no stone can cover, since it is narrower than a joint there: parts of it that would be a bare spot,
// wider than half of `widest_bare`. None where joints are narrower than that. `size` is that of its own stone.
std::vector<geometry::Region> bare_ends(const geometry::Polygon& piece, const StoneSize& size);

// The faces of a piece that are laid: trimmed to the stock, and without scraps.
std::vector<geometry::Polygon> laid_faces(const Piece& piece, const StoneSize& size);

}  // namespace shatterpave::paving
