// Sets of whole numbers that are joined step by step (union–find). A set is known by its least member, whatever the order in
// which its members were joined.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace shatterpave {

class DisjointSets {
 public:
  // Starts with the sets {0} … {count − 1}.
  explicit DisjointSets(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), std::size_t{0}); }

  // The least member of the set that `i` is in.
  std::size_t of(std::size_t i) const {
    while (above_[i] != i) i = above_[i];
    return i;
  }
  // The same; it also shortens the path to that member for later calls.
  std::size_t of(std::size_t i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }

  void join(std::size_t a, std::size_t b) {
    a = of(a);
    b = of(b);
    above_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> above_;  // a smaller member of the same set; itself if it is the least
};

}  // namespace shatterpave
