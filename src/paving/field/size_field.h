// The size of a packed stone at every place of a pavement, as a part of the stone that is asked for (§3 of Miyata and Itoh
// packs squares of one size; sizes that follow a field go beyond it).
//
// What a scene asks for is sampled on a grid. Sizes that change from one stone to the next by more than a row can bear are then
// made smaller, towards the smaller ones: s(x) = min over y of s(y) + g |x − y| / pitch, with g `most_growth`, as meshers limit
// the growth of their elements (Persson, "Mesh size functions for implicit geometries and PDE-based gradient limiting", 2006).
// Distances on the grid are Borgefors' chamfer, along its rows, columns and diagonals: up to 8 % longer.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/polygon.h"
#include "geometry/region_index.h"
#include "paving/pavement.h"

namespace shatterpave::paving {

// How much larger a stone is, as a part of `stone_mm`, than the one before it, at the most. By trial on plans of
// benchmarks/packing_quality: with twice as much every fifth stone has other than four sides.
inline constexpr double most_growth = 0.1;

class SizeField {
 public:
  // `area` is that of the pavement; it is not kept.
  SizeField(const Pavement& pavement, const geometry::RegionIndex& area);

  // The size at `place`, which may lie outside the area; 1 where stones are alike.
  double at(vec2 place) const;
  // Whether stones are alike, of `stone_mm`.
  bool is_even() const { return sizes_.empty(); }
  double smallest() const { return smallest_; }
  double largest() const { return largest_; }
  // Of stones that lie at the border of an area, or within a stone of it.
  double largest_along(const geometry::RegionIndex& area) const;

 private:
  vec2 node(std::size_t column, std::size_t row) const;
  void sample(const Pavement& pavement, const geometry::RegionIndex& area);
  void limit_growth();

  vec2 origin_{0.0, 0.0};
  double spacing_mm_ = 1.0;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<float> sizes_;  // in rows from the lowest; empty where stones are alike
  double smallest_ = 1.0;
  double largest_ = 1.0;
  double longer_mm_ = 1.0;  // the longer pitch of a stone of size 1
};

}  // namespace shatterpave::paving
