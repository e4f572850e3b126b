#include "geometry/point_index.h"

#include <algorithm>
#include <limits>

namespace shatterpave::geometry {

namespace {

constexpr vec2 nowhere{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

}  // namespace

void PointIndex::put(int number, vec2 at_mm) {
  const auto place = static_cast<std::size_t>(number);
  if (points_.size() <= place) points_.resize(place + 1, nowhere);
  const vec2 before = points_[place];
  points_[place] = at_mm;
  const std::int64_t column = cell_of(at_mm.x);
  const std::int64_t row = cell_of(at_mm.y);
  if (before != nowhere) {
    if (cell_of(before.x) == column && cell_of(before.y) == row) return;
    grid_.remove(cell_of(before.x), cell_of(before.y), number);
    --count_;
  }
  ++count_;
  grid_.add(column, row, number);
}

void PointIndex::remove(int number) {
  vec2& point = points_[static_cast<std::size_t>(number)];
  grid_.remove(cell_of(point.x), cell_of(point.y), number);
  point = nowhere;
  --count_;
}

// Looks first as far as the wanted number of points is likely to lie, then twice as far each time, so that in a crowd only the
// nearest are visited.
std::size_t PointIndex::nearest_in(const Sector& sector, std::span<Found> found) const {
  if (found.empty()) return 0;
  double reach = sector.radius();
  for (std::size_t crowd = 16 * found.size(); crowd < count_; crowd *= 4) reach *= 0.5;
  for (;; reach = std::min(2.0 * reach, sector.radius())) {
    const std::size_t count = nearest_within(sector, reach, found);
    const bool full = count == found.size() && found[count - 1].distance2 <= reach * reach;
    if (full || reach >= sector.radius()) return count;
  }
}

std::size_t PointIndex::nearest_within(const Sector& sector, double reach, std::span<Found> found) const {
  std::size_t count = 0;
  const auto [low, high] = sector.bounds(reach);
  visit_in({low, high}, [&](int number) {
    const vec2 offset = at(number) - sector.apex();
    const Found candidate{number, glm::dot(offset, offset)};
    if (count == found.size() && !(candidate < found[count - 1])) return;
    if (candidate.distance2 == 0.0 || !sector.contains(at(number))) return;
    if (count < found.size()) ++count;
    std::size_t place = count - 1;
    for (; place > 0 && candidate < found[place - 1]; --place) found[place] = found[place - 1];
    found[place] = candidate;
  });
  return count;
}

}  // namespace shatterpave::geometry
