#include "geometry/segment_index.h"

#include <bit>

#include "core/error.h"

namespace shatterpave::geometry {

// A cell of at least 2 units keeps columns and rows within the ±2^30 of CellGrid.
SegmentIndex::SegmentIndex(double cell_mm)
    : cell_bits_(static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::max<std::int64_t>(2, to_lattice(cell_mm))))) -
                 1) {
  ENSURE(cell_mm > 0.0);
}

int SegmentIndex::add(const Segment& segment) {
  const int number = static_cast<int>(segments_.size());
  const auto narrow = [](std::int64_t coordinate) {
    const auto kept = static_cast<std::int32_t>(coordinate);
    ENSURE(kept == coordinate);
    return kept;
  };
  segments_.push_back({narrow(segment.a.x), narrow(segment.a.y), narrow(segment.b.x), narrow(segment.b.y), segment.owner});
  visit_cells(segment.a, segment.b, [&](std::int64_t column, std::int64_t row) { grid_.add(column, row, number); });
  return number;
}

void SegmentIndex::remove(int number) {
  const Segment gone = segment(number);
  visit_cells(gone.a, gone.b, [&](std::int64_t column, std::int64_t row) { grid_.remove(column, row, number); });
}

std::vector<int> SegmentIndex::near(LatticePoint p, LatticePoint q) const {
  std::vector<int> found;
  const CellBox box{cell_of(std::min(p.x, q.x)), cell_of(std::min(p.y, q.y)), cell_of(std::max(p.x, q.x)),
                    cell_of(std::max(p.y, q.y))};
  grid_.visit_occupied(box, [&](std::int64_t column, std::int64_t row) {
    grid_.visit(column, row, [&](int number) { found.push_back(number); });
  });
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void SegmentIndex::improve(const Sector& sector, int number, std::optional<Nearest>& best) const {
  const Segment candidate = segment(number);
  const std::optional<vec2> point = sector.nearest_point(to_mm(candidate.a), to_mm(candidate.b));
  if (!point) return;
  const double distance = glm::length(*point - sector.apex());
  const bool nearer = !best || distance < best->distance_mm || (distance == best->distance_mm && number < best->number);
  if (nearer) best = Nearest{number, *point, distance};
}

}  // namespace shatterpave::geometry
