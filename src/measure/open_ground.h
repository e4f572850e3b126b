// What stones leave open of an area, tile by tile.
#pragma once

#include <vector>

#include "geometry/region_index.h"
#include "measure/stone_index.h"
#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::measure {

// The area lies in square tiles of a few stones, so that a polygon clipper never sees more than some hundred of them: all
// together take time that goes with the number of stones.
class OpenGround {
 public:
  struct Rules {
    double miter_limit = 2.0;  // a grown stone's corner is sharp where its tip lies within as many half joints,
    bool long_tips = false;    // else cut square there, or a half joint from the stone
    bool free_border = false;  // the half joint along the border does not count as open
  };

  //   index   of the layout; it, the layout, the pavement and `area`, which is of the pavement, must outlive this
  OpenGround(const paving::Pavement& pavement, const paving::StoneLayout& layout, const StoneIndex& index,
             const geometry::RegionIndex& area, const Rules& rules);

  std::size_t tiles() const { return columns_ * rows_; }
  geometry::Box tile(std::size_t number) const;

  // What the stones grown by half a joint leave of the area within `box`, on the lattice.
  std::vector<geometry::Region> open(const geometry::Box& box) const;

 private:
  std::vector<geometry::Region> ground(const geometry::Box& box) const;

  const paving::Pavement& pavement_;
  const paving::StoneLayout& layout_;
  const StoneIndex& index_;
  const geometry::RegionIndex& area_;
  Rules rules_;
  std::vector<geometry::Region> ground_;
  double side_mm_ = 1.0;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
};

}  // namespace shatterpave::measure
