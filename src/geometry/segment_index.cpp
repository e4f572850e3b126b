#include "geometry/segment_index.h"

#include "core/error.h"

namespace shatterpave::geometry {

namespace {

// Columns and rows stay below 2^31: coordinates are within ±1 km, and a cell is at least one lattice unit wide.
std::uint64_t key(std::int64_t column, std::int64_t row) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32U) | static_cast<std::uint32_t>(row);
}

}  // namespace

SegmentIndex::SegmentIndex(double cell_mm) : cell_size_(std::max<std::int64_t>(1, to_lattice(cell_mm))) {
  ENSURE(cell_mm > 0.0);
}

std::int64_t SegmentIndex::cell_of(std::int64_t coordinate) const {
  return coordinate >= 0 ? coordinate / cell_size_ : -((cell_size_ - 1 - coordinate) / cell_size_);
}

const SegmentIndex::Cell* SegmentIndex::cell(std::int64_t column, std::int64_t row) const {
  const auto found = cells_.find(key(column, row));
  return found == cells_.end() ? nullptr : &found->second;
}

int SegmentIndex::add(const Segment& segment) {
  const int number = static_cast<int>(segments_.size());
  segments_.push_back(segment);
  visit_cells(segment.a, segment.b, [&](std::int64_t column, std::int64_t row) { cells_[key(column, row)].push_back(number); });
  return number;
}

void SegmentIndex::remove(int number) {
  const Segment& gone = segment(number);
  visit_cells(gone.a, gone.b, [&](std::int64_t column, std::int64_t row) { std::erase(cells_[key(column, row)], number); });
}

void SegmentIndex::add_all(const SegmentIndex& other) {
  for (const Segment& segment : other.segments_) add(segment);
}

std::vector<int> SegmentIndex::near(LatticePoint p, LatticePoint q) const {
  std::vector<int> found;
  const std::int64_t last_row = cell_of(std::max(p.y, q.y));
  const std::int64_t last_column = cell_of(std::max(p.x, q.x));
  for (std::int64_t row = cell_of(std::min(p.y, q.y)); row <= last_row; ++row) {
    for (std::int64_t column = cell_of(std::min(p.x, q.x)); column <= last_column; ++column) {
      if (const Cell* here = cell(column, row)) found.insert(found.end(), here->begin(), here->end());
    }
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void SegmentIndex::improve(const Sector& sector, int owner, const Cell& cell, std::optional<Nearest>& best) const {
  for (const int number : cell) {
    const Segment& candidate = segment(number);
    if (candidate.owner == owner) continue;
    const std::optional<vec2> point = sector.nearest_point(to_mm(candidate.a), to_mm(candidate.b));
    if (!point) continue;
    const double distance = glm::length(*point - sector.apex());
    const bool nearer = !best || distance < best->distance_mm || (distance == best->distance_mm && number < best->number);
    if (nearer) best = Nearest{number, *point, distance};
  }
}

// Rings of cells about the apex, outwards, until none can hold anything nearer.
std::optional<SegmentIndex::Nearest> SegmentIndex::nearest_in(const Sector& sector, int owner) const {
  std::optional<Nearest> best;
  const LatticePoint apex = to_lattice(sector.apex());
  const std::int64_t column = cell_of(apex.x);
  const std::int64_t row = cell_of(apex.y);
  const double cell_mm = to_mm(cell_size_);
  const auto look = [&](std::int64_t c, std::int64_t r) {
    const Cell* here = cell(c, r);
    if (here == nullptr || here->empty()) return;
    const vec2 low = vec2{static_cast<double>(c), static_cast<double>(r)} * cell_mm;
    if (sector.may_meet(low, low + cell_mm)) improve(sector, owner, *here, best);
  };
  for (std::int64_t ring = 0; static_cast<double>(ring - 1) * cell_mm <= (best ? best->distance_mm : sector.radius()); ++ring) {
    for (std::int64_t r = row - ring; r <= row + ring; ++r) {
      const bool whole_row = r == row - ring || r == row + ring;
      const std::int64_t stride = whole_row || ring == 0 ? 1 : 2 * ring;
      for (std::int64_t c = column - ring; c <= column + ring; c += stride) look(c, r);
    }
  }
  return best;
}

}  // namespace shatterpave::geometry
