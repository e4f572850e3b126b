// Points sorted into squares of a fixed size, to be asked for those near a place. Points can be added. Where what is packed
// differs in size, squares are for the smallest, and a question about a larger one looks at more of them: so a look costs what
// lies near.
//
// It stands beside geometry/point_index.h, which also moves points and finds the nearest: a packing is asked for all neighbours
// of all points at once, adds up forces in the order in which they are visited, and so keeps its own order and its bits.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/vec.h"

namespace shatterpave::paving {

class NearIndex {
 public:
  // `square_mm` is the reach of a question; `expected` the number of points.
  NearIndex(double square_mm, std::size_t expected) : square_mm_(square_mm) {
    std::size_t slots = 64;
    while (slots < 2 * expected) slots *= 2;
    heads_.assign(slots, none);
    next_.reserve(expected);
  }

  // Adds the next point; points are numbered in the order in which they come.
  void add(vec2 at) {
    const std::size_t slot = slot_of(column(at.x), column(at.y));
    next_.push_back(heads_[slot]);
    heads_[slot] = static_cast<std::uint32_t>(next_.size() - 1);
  }

  // Calls `visit(index)` for every point within the reach of `at`, and for some that are farther; each at most once unless
  // squares share a slot, which the visitor must bear. The order depends on the points alone.
  template <typename Visit>
  void for_each_near(vec2 at, Visit visit) const {
    for_each_within(at, 1, visit);
  }
  // The same for another reach.
  template <typename Visit>
  void for_each_near(vec2 at, double reach_mm, Visit visit) const {
    for_each_within(at, static_cast<std::int64_t>(std::ceil(reach_mm / square_mm_)), visit);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  template <typename Visit>
  void for_each_within(vec2 at, std::int64_t squares, Visit visit) const {
    const std::int64_t c = column(at.x);
    const std::int64_t r = column(at.y);
    for (std::int64_t dr = -squares; dr <= squares; ++dr) {
      for (std::int64_t dc = -squares; dc <= squares; ++dc) {
        for (std::uint32_t i = heads_[slot_of(c + dc, r + dr)]; i != none; i = next_[i]) visit(i);
      }
    }
  }

  std::int64_t column(double mm) const { return static_cast<std::int64_t>(std::floor(mm / square_mm_)); }
  std::size_t slot_of(std::int64_t c, std::int64_t r) const {
    // Teschner et al., "Optimized spatial hashing for collision detection of deformable objects" (2003): the primes.
    const std::uint64_t mixed = (static_cast<std::uint64_t>(c) * 73856093U) ^ (static_cast<std::uint64_t>(r) * 19349663U);
    return static_cast<std::size_t>(mixed) & (heads_.size() - 1);
  }

  double square_mm_;
  std::vector<std::uint32_t> heads_;
  std::vector<std::uint32_t> next_;
};

}  // namespace shatterpave::paving
