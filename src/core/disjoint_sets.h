// Sets of whole numbers that are joined step by step (union–find); each is known by its least member, in whatever order they
// were joined.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace shatterpave {

class DisjointSets {
 public:
  // 0 … count − 1, each by itself.
  explicit DisjointSets(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), std::size_t{0}); }

  // The least member of the set that `i` is in.
  std::size_t of(std::size_t i) const {
    while (above_[i] != i) i = above_[i];
    return i;
  }
  // The same, and it shortens the way there for the next time.
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
  std::vector<std::size_t> above_;  // one of the same set, no greater; itself where it is the least
};

}  // namespace shatterpave
