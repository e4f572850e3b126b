#include "geometry/point_index.h"

#include <algorithm>
#include <numeric>

namespace shatterpave::geometry {

namespace {

// Nodes with no more points than this are searched point by point.
constexpr std::size_t leaf_size = 8;

}  // namespace

struct PointIndex::Search {
  struct Found {
    double distance2;
    int place;
    bool operator<(const Found& other) const {
      return distance2 != other.distance2 ? distance2 < other.distance2 : place < other.place;
    }
  };
  const Sector& sector;
  std::size_t count;
  std::vector<Found> nearest;  // ascending

  bool wants(const Found& found) const { return nearest.size() < count || found < nearest.back(); }
  void take(const Found& found) {
    if (!wants(found)) return;
    if (nearest.size() == count) nearest.pop_back();
    nearest.insert(std::upper_bound(nearest.begin(), nearest.end(), found), found);
  }
};

PointIndex::PointIndex(std::span<const vec2> points) : points_(points), order_(points.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!points.empty()) build(0, 0, points.size());
}

void PointIndex::build(std::size_t node, std::size_t first, std::size_t last) {
  if (boxes_.size() <= node) boxes_.resize(node + 1);
  const auto at = [this](int place) { return points_[static_cast<std::size_t>(place)]; };
  Box box{at(order_[first]), at(order_[first])};
  for (std::size_t i = first; i < last; ++i) {
    box.low = glm::min(box.low, at(order_[i]));
    box.high = glm::max(box.high, at(order_[i]));
  }
  boxes_[node] = box;
  if (last - first <= leaf_size) return;
  const vec2 extent = box.high - box.low;
  const std::size_t axis = extent.x >= extent.y ? 0 : 1;
  const std::size_t middle = (first + last) / 2;
  const auto begin = order_.begin();
  std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(middle),
                   begin + static_cast<std::ptrdiff_t>(last),
                   [&](int p, int q) { return at(p)[axis] != at(q)[axis] ? at(p)[axis] < at(q)[axis] : p < q; });
  build(2 * node + 1, first, middle);
  build(2 * node + 2, middle, last);
}

void PointIndex::search(std::size_t node, std::size_t first, std::size_t last, Search& search) const {
  const Box& box = boxes_[node];
  const vec2 gap = glm::clamp(search.sector.apex(), box.low, box.high) - search.sector.apex();
  if (!search.wants({glm::dot(gap, gap), -1}) || !search.sector.may_meet(box.low, box.high)) return;
  if (last - first <= leaf_size) {
    for (std::size_t i = first; i < last; ++i) {
      const vec2 point = points_[static_cast<std::size_t>(order_[i])];
      const vec2 offset = point - search.sector.apex();
      const double distance2 = glm::dot(offset, offset);
      if (distance2 > 0.0 && search.sector.contains(point)) search.take({distance2, order_[i]});
    }
    return;
  }
  const std::size_t middle = (first + last) / 2;
  this->search(2 * node + 1, first, middle, search);
  this->search(2 * node + 2, middle, last, search);
}

std::vector<int> PointIndex::nearest_in(const Sector& sector, std::size_t count) const {
  Search search{sector, count, {}};
  if (!points_.empty() && count > 0) this->search(0, 0, points_.size(), search);
  std::vector<int> places(search.nearest.size());
  std::ranges::transform(search.nearest, places.begin(), [](const Search::Found& found) { return found.place; });
  return places;
}

}  // namespace shatterpave::geometry
