#include "trace/skeleton.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace shatterpave::trace {

namespace {

// The eight neighbours in order, from above, clockwise: bit i of a pattern says whether neighbour i is part of the figure.
constexpr std::array<std::array<int, 2>, 8> neighbours = {
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

bool has(unsigned pattern, unsigned i) { return ((pattern >> i) & 1U) != 0; }

// Whether a pixel with such neighbours is taken off in the first or the second pass of the paper's step.
bool is_taken_off(unsigned pattern, bool second) {
  int count = 0;
  int rises = 0;
  for (unsigned i = 0; i < 8; ++i) {
    count += has(pattern, i) ? 1 : 0;
    rises += !has(pattern, i) && has(pattern, (i + 1) % 8) ? 1 : 0;
  }
  if (count < 2 || count > 6 || rises != 1) return false;
  const bool up = has(pattern, 0);
  const bool right = has(pattern, 2);
  const bool down = has(pattern, 4);
  const bool left = has(pattern, 6);
  return second ? !(up && right && left) && !(up && down && left) : !(up && right && down) && !(right && down && left);
}

using Table = std::array<std::array<bool, 256>, 2>;

Table table_of_rules() {
  Table table{};
  for (unsigned pattern = 0; pattern < 256; ++pattern) {
    table[0][pattern] = is_taken_off(pattern, false);
    table[1][pattern] = is_taken_off(pattern, true);
  }
  return table;
}

unsigned pattern_at(const Mask& framed, std::size_t at) {
  unsigned pattern = 0;
  for (unsigned i = 0; i < 8; ++i) {
    const std::ptrdiff_t step = std::ptrdiff_t{neighbours[i][1]} * framed.width + neighbours[i][0];
    if (framed.values[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(at) + step)] != 0) pattern |= 1U << i;
  }
  return pattern;
}

// One pass over the figure; whether it took anything off.
bool thin(const std::array<bool, 256>& is_off, Mask& framed, std::vector<std::size_t>& figure) {
  std::vector<std::size_t> off;
  std::ranges::copy_if(figure, std::back_inserter(off), [&](std::size_t at) { return is_off[pattern_at(framed, at)]; });
  for (const std::size_t at : off) framed.values[at] = 0;
  std::erase_if(figure, [&](std::size_t at) { return framed.values[at] == 0; });
  return !off.empty();
}

}  // namespace

Mask skeleton(const Mask& mask) {
  static const Table table = table_of_rules();
  // With a frame of a pixel, so that every pixel has eight neighbours.
  Mask framed(mask.width + 2, mask.height + 2);
  std::vector<std::size_t> figure;
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      if (mask.at(x, y) == 0) continue;
      framed.at(x + 1, y + 1) = 1;
      figure.push_back(framed.index(x + 1, y + 1));
    }
  }
  for (bool changed = true; changed;) {
    const bool first = thin(table[0], framed, figure);
    changed = thin(table[1], framed, figure) || first;
  }
  Mask result(mask.width, mask.height);
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) result.at(x, y) = framed.at(x + 1, y + 1);
  }
  return result;
}

}  // namespace shatterpave::trace
