// Stones found by place, for questions about neighbours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/polygon.h"
#include "paving/stones.h"

namespace shatterpave::measure {

// The stones of a layout, by the squares of a grid that their boxes meet. Outlines are not kept.
class StoneIndex {
 public:
  // Squares are `square_mm` > 0 wide, or wider where stones are few for the area.
  StoneIndex(const paving::StoneLayout& layout, double square_mm);

  const geometry::Box& box(std::size_t stone) const { return boxes_[stone]; }

  // Fills `found` with the stones whose boxes meet `box`, ascending.
  void near(const geometry::Box& box, std::vector<std::size_t>& found) const;

 private:
  struct Squares {
    std::size_t first_column = 0;
    std::size_t first_row = 0;
    std::size_t last_column = 0;  // inclusive
    std::size_t last_row = 0;
  };
  Squares squares_of(const geometry::Box& box) const;
  template <typename Visit>
  void visit_squares(const geometry::Box& box, Visit visit) const {
    const Squares at = squares_of(box);
    for (std::size_t row = at.first_row; row <= at.last_row; ++row) {
      for (std::size_t column = at.first_column; column <= at.last_column; ++column) visit(row * columns_ + column);
    }
  }

  std::vector<geometry::Box> boxes_;
  vec2 origin_{0.0, 0.0};
  double square_mm_;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::size_t> first_;  // stones of square q are stones_[first_[q] … first_[q + 1])
  std::vector<std::uint32_t> stones_;
};

}  // namespace shatterpave::measure
