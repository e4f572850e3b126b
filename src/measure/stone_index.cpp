#include "measure/stone_index.h"

#include <algorithm>
#include <cmath>

namespace shatterpave::measure {

namespace {

// For each stone at most, so that memory goes with what is kept.
constexpr double squares_to_a_stone = 4.0;

geometry::Box box_about(const std::vector<geometry::Box>& boxes) {
  if (boxes.empty()) return {};
  geometry::Box all = boxes.front();
  for (const geometry::Box& box : boxes) all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
  return all;
}

}  // namespace

StoneIndex::StoneIndex(const paving::StoneLayout& layout, double square_mm) : square_mm_(square_mm) {
  boxes_.reserve(layout.stones.size());
  for (const paving::Stone& stone : layout.stones) boxes_.push_back(geometry::bounding_box(stone.outline_mm));
  const geometry::Box all = box_about(boxes_);
  const vec2 size = all.high - all.low;
  origin_ = all.low;
  const double most = squares_to_a_stone * static_cast<double>(boxes_.size() + 1);
  square_mm_ = std::max({square_mm_, std::sqrt(size.x * size.y / most), std::max(size.x, size.y) / most});
  columns_ = static_cast<std::size_t>(size.x / square_mm_) + 1;
  rows_ = static_cast<std::size_t>(size.y / square_mm_) + 1;
  // Count, offsets, fill.
  first_.assign(columns_ * rows_ + 1, 0);
  for (const geometry::Box& box : boxes_) visit_squares(box, [&](std::size_t square) { ++first_[square + 1]; });
  for (std::size_t square = 0; square < columns_ * rows_; ++square) first_[square + 1] += first_[square];
  stones_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t s = 0; s < boxes_.size(); ++s) {
    visit_squares(boxes_[s], [&](std::size_t square) { stones_[next[square]++] = static_cast<std::uint32_t>(s); });
  }
}

StoneIndex::Squares StoneIndex::squares_of(const geometry::Box& box) const {
  const auto square = [&](double mm, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(std::floor(mm / square_mm_), 0.0, static_cast<double>(count - 1)));
  };
  const vec2 low = box.low - origin_;
  const vec2 high = box.high - origin_;
  return {square(low.x, columns_), square(low.y, rows_), square(high.x, columns_), square(high.y, rows_)};
}

void StoneIndex::near(const geometry::Box& box, std::vector<std::size_t>& found) const {
  found.clear();
  visit_squares(box, [&](std::size_t square) {
    for (std::size_t k = first_[square]; k < first_[square + 1]; ++k) {
      if (geometry::boxes_meet(boxes_[stones_[k]], box)) found.push_back(stones_[k]);
    }
  });
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

}  // namespace shatterpave::measure
