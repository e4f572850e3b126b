// From cells to stones: cut at the outline and holes, small pieces joined to their neighbours, and the joint taken off.
#pragma once

#include <vector>

#include "geometry/region_index.h"
#include "paving/cells.h"
#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::paving {

// The least part of a whole stone's face that is laid as a stone of its own, where it has a neighbour to be joined to.
// Source: design target of this project; paviours' guides ask for a quarter to a third of a sett at the least.
inline constexpr double least_piece = 0.25;

// A cell, or what is left of it, before the joint is taken off.
struct Piece {
  geometry::Polygon outline_mm;  // counter-clockwise, simple
  std::uint32_t cell = 0;        // the cell it is of, or the largest of those
  bool cut = false;              // the outline or a hole took part of it, or it was joined
};

// What the rule of the smallest piece needs to know of the stones.
struct StoneSize {
  double whole_face_mm2 = 0.0;
  double joint_mm = 0.0;
  // A piece that lost no more of its cell than this is whole: cells that were set out along the border end there but for
  // rounding.
  double rounding_mm2 = -1.0;
};

// The pieces of the cells within `region`, of which `index` is made; none small that has a neighbour.
std::vector<Piece> pieces_within(const Cells& cells, const geometry::Region& region, const geometry::RegionIndex& index,
                                 const StoneSize& size);

// The piece's face: its outline moved in by half the joint. Empty if nothing is left; several where it falls apart.
std::vector<geometry::Polygon> faces_of(const geometry::Polygon& piece, double joint_mm);

}  // namespace shatterpave::paving
