// A sequence that only grows and never moves its elements, for much data, where copying would cost more than all else.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <memory>
#include <vector>

namespace shatterpave::geometry {

// The part of a vector that the indexes need, in blocks of one size. A std::deque has blocks of 512 bytes, so it allocates for
// every few values, and it divides to find a place.
template <typename Value>
class GrowingStore {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const Value& operator[](std::size_t at) const { return blocks_[at / block_size][at % block_size]; }
  Value& operator[](std::size_t at) { return blocks_[at / block_size][at % block_size]; }

  Value& push_back(const Value& value) {
    if (size_ == blocks_.size() * block_size) blocks_.push_back(std::make_unique_for_overwrite<Value[]>(block_size));
    Value& place = (*this)[size_++];
    place = value;
    return place;
  }

 private:
  // Values in a block, a power of two, about 8 KiB: by eye, large beside an allocation's cost, small beside a pane's data.
  static constexpr std::size_t block_size = std::bit_floor(std::max<std::size_t>(1, 8192 / sizeof(Value)));

  std::vector<std::unique_ptr<Value[]>> blocks_;
  std::size_t size_ = 0;
};

}  // namespace shatterpave::geometry
