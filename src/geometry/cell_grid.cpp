#include "geometry/cell_grid.h"

#include <algorithm>

#include "core/error.h"

namespace shatterpave::geometry {

void CellGrid::grow() {
  std::vector<Slot> old(std::max<std::size_t>(64, 2 * slots_.size()));
  std::swap(old, slots_);
  shift_ = 64 - std::countr_zero(slots_.size());
  for (const Slot& kept : old) {
    if (kept.tile != none) slots_[slot(kept.key)] = kept;
  }
}

CellGrid::Tile& CellGrid::made_tile(std::int64_t column, std::int64_t row) {
  if (2 * tiles_.size() >= slots_.size()) grow();
  const std::uint64_t wanted = key(column, row);
  Slot& found = slots_[slot(wanted)];
  if (found.tile == none) {
    found = {wanted, static_cast<int>(tiles_.size())};
    tiles_.push_back({}).first.fill(none);
  }
  return tiles_[static_cast<std::size_t>(found.tile)];
}

int CellGrid::fresh_chunk(int next) {
  const int at = free_ != none ? free_ : static_cast<int>(chunks_.size());
  if (free_ == none) {
    chunks_.push_back({});
  } else {
    free_ = chunks_[static_cast<std::size_t>(free_)].next;
  }
  chunks_[static_cast<std::size_t>(at)].next = next;
  chunks_[static_cast<std::size_t>(at)].count = 0;
  return at;
}

void CellGrid::add(std::int64_t column, std::int64_t row, int number) {
  Tile& tile = made_tile(column, row);
  int& first = tile.first[place(column, row)];
  const bool full = first == none || chunks_[static_cast<std::size_t>(first)].count == std::ssize(Chunk{}.numbers);
  if (full) first = fresh_chunk(first);
  Chunk& chunk = chunks_[static_cast<std::size_t>(first)];
  chunk.numbers[static_cast<std::size_t>(chunk.count++)] = number;
  tile.occupied |= std::uint64_t{1} << place(column, row);
}

// The last number of the first chunk takes the place of the removed one.
void CellGrid::remove(std::int64_t column, std::int64_t row, int number) {
  Tile& tile = made_tile(column, row);
  int& first = tile.first[place(column, row)];
  for (int at = first; at != none; at = chunks_[static_cast<std::size_t>(at)].next) {
    Chunk& chunk = chunks_[static_cast<std::size_t>(at)];
    const auto end = chunk.numbers.begin() + chunk.count;
    const auto found = std::find(chunk.numbers.begin(), end, number);
    if (found == end) continue;
    Chunk& head = chunks_[static_cast<std::size_t>(first)];
    *found = head.numbers[static_cast<std::size_t>(--head.count)];
    if (head.count > 0) return;
    const int emptied = first;
    first = head.next;
    head.next = free_;
    free_ = emptied;
    if (first == none) tile.occupied &= ~(std::uint64_t{1} << place(column, row));
    return;
  }
  ENSURE(false);
}

}  // namespace shatterpave::geometry
