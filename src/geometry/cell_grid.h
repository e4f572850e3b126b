// Numbers kept by the cell of an endless grid in which they lie. Cells come in hashed tiles of 8 × 8, each of which knows its
// occupied cells: so empty cells cost next to nothing, and memory grows with what is kept.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/growing_store.h"

namespace shatterpave::geometry {

struct CellBox {
  std::int64_t first_column = 0;
  std::int64_t first_row = 0;
  std::int64_t last_column = 0;  // inclusive
  std::int64_t last_row = 0;
};

// The largest whole number not above `value`, which must fit; without a call of the C library.
inline std::int64_t whole_below(double value) {
  const auto towards_zero = static_cast<std::int64_t>(value);
  return static_cast<double>(towards_zero) > value ? towards_zero - 1 : towards_zero;
}

// Columns and rows lie within ±2^30.
class CellGrid {
 public:
  void add(std::int64_t column, std::int64_t row, int number);
  // REQUIRES that the number is in the cell.
  void remove(std::int64_t column, std::int64_t row, int number);

  // Calls visit(number) for each number of the cell, in an order that depends on the calls of `add` and `remove` only.
  template <typename Visit>
  void visit(std::int64_t column, std::int64_t row, Visit visit) const {
    if (const Tile* here = tile(column, row)) visit_chunks(here->first[place(column, row)], visit);
  }

  // Whether any cell of the box holds anything.
  bool is_empty(const CellBox& box) const {
    bool empty = true;
    visit_tiles(box, [&](std::int64_t, std::int64_t, std::uint64_t cells) { empty = empty && cells == 0; });
    return empty;
  }

  // Calls visit(column, row) for each cell of the box that holds anything.
  template <typename Visit>
  void visit_occupied(const CellBox& box, Visit visit) const {
    visit_tiles(box, [&](std::int64_t column, std::int64_t row, std::uint64_t cells) {
      for (; cells != 0; cells &= cells - 1) {
        const int bit = std::countr_zero(cells);
        visit(column + bit % 8, row + bit / 8);
      }
    });
  }

 private:
  static constexpr int none = -1;
  // A piece of the list of a cell. All pieces but the first are full.
  struct Chunk {
    int next = none;
    int count = 0;
    std::array<int, 6> numbers{};
  };
  struct Tile {
    std::uint64_t occupied = 0;  // bit 8 row + column, within the tile
    std::array<int, 64> first{};
  };
  struct Slot {
    std::uint64_t key = 0;
    int tile = none;
  };

  static std::int64_t tile_end(std::int64_t cell) { return (cell | 7) + 1; }
  static std::size_t place(std::int64_t column, std::int64_t row) {
    return static_cast<std::size_t>(8 * (row & 7) + (column & 7));
  }
  static std::uint64_t key(std::int64_t column, std::int64_t row) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(column >> 3)) << 32U) | static_cast<std::uint32_t>(row >> 3);
  }
  // The cells of a tile whose columns lie from `first` to `last`, the former within the tile.
  static std::uint64_t columns_of(std::int64_t first, std::int64_t last) {
    const auto end = static_cast<unsigned>(last < tile_end(first) ? last & 7 : 7);
    return 0x0101010101010101ULL * ((0xffU >> (7U - end)) & (0xffU << static_cast<unsigned>(first & 7)) & 0xffU);
  }
  static std::uint64_t rows_of(std::int64_t first, std::int64_t last) {
    const auto end = static_cast<unsigned>(last < tile_end(first) ? last & 7 : 7);
    return (~std::uint64_t{0} >> (8U * (7U - end))) & (~std::uint64_t{0} << (8U * static_cast<unsigned>(first & 7)));
  }

  // Calls visit(column, row, cells) for each tile that has cells in the box: its first column and row, and those of its
  // occupied cells that lie in the box.
  template <typename Visit>
  void visit_tiles(const CellBox& box, Visit visit) const {
    for (std::int64_t row = box.first_row; row <= box.last_row; row = tile_end(row)) {
      for (std::int64_t column = box.first_column; column <= box.last_column; column = tile_end(column)) {
        const Tile* here = tile(column, row);
        if (here == nullptr) continue;
        visit(column & ~std::int64_t{7}, row & ~std::int64_t{7},
              here->occupied & columns_of(column, box.last_column) & rows_of(row, box.last_row));
      }
    }
  }
  const Tile* tile(std::int64_t column, std::int64_t row) const {
    if (slots_.empty()) return nullptr;
    const Slot& found = slots_[slot(key(column, row))];
    return found.tile == none ? nullptr : &tiles_[static_cast<std::size_t>(found.tile)];
  }
  // The slot that holds the key, or the free one where it belongs.
  std::size_t slot(std::uint64_t key) const {
    // Fibonacci hashing: Knuth, The Art of Computer Programming, vol. 3, §6.4.
    std::size_t at = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ULL) >> shift_);
    while (slots_[at].tile != none && slots_[at].key != key) at = (at + 1) & (slots_.size() - 1);
    return at;
  }
  template <typename Visit>
  void visit_chunks(int first, Visit& visit) const {
    for (int at = first; at != none; at = chunks_[static_cast<std::size_t>(at)].next) {
      const Chunk& chunk = chunks_[static_cast<std::size_t>(at)];
      for (int i = 0; i < chunk.count; ++i) visit(chunk.numbers[static_cast<std::size_t>(i)]);
    }
  }
  Tile& made_tile(std::int64_t column, std::int64_t row);
  void grow();
  int fresh_chunk(int next);

  std::vector<Slot> slots_;  // a power of two of them, at most half in use
  int shift_ = 0;            // 64 − log2 of their number
  GrowingStore<Tile> tiles_;
  GrowingStore<Chunk> chunks_;
  int free_ = none;  // first of the chunks that are not in use
};

}  // namespace shatterpave::geometry
