// An index of segments by place: a uniform grid, so that a question costs what lies near, however many segments lie elsewhere.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/cell_grid.h"
#include "geometry/growing_store.h"
#include "geometry/lattice.h"
#include "geometry/polygon.h"
#include "geometry/sector.h"

namespace shatterpave::geometry {

struct Segment {
  LatticePoint a;
  LatticePoint b;
  int owner = 0;  // whatever the caller wants to know it by

  bool operator==(const Segment&) const = default;
};

class SegmentIndex {
 public:
  // Cells are squares, of `cell_mm` > 0 or down to half as wide. Best near the length of a typical segment.
  explicit SegmentIndex(double cell_mm);

  // The number of the new segment. Numbers are never used twice.
  int add(const Segment& segment);
  void remove(int number);
  Segment segment(int number) const {
    const Kept& kept = segments_[static_cast<std::size_t>(number)];
    return {{kept.ax, kept.ay}, {kept.bx, kept.by}, kept.owner};
  }

  // Calls visit(number) for every segment that may have a point in common with the one from `p` to `q`: for all that have, for
  // some that only come near, and for some more than once, in an order that depends on the calls of `add` and `remove` only.
  template <typename Visit>
  void visit_near(LatticePoint p, LatticePoint q, Visit visit) const {
    visit_cells(p, q, [&](std::int64_t column, std::int64_t row) { grid_.visit(column, row, visit); });
  }

  // Calls visit(number) for every segment that may have a point in the box, as visit_near does.
  template <typename Visit>
  void visit_in(const Box& box, Visit visit) const {
    grid_.visit_occupied(cells_of(box.low, box.high),
                         [&](std::int64_t column, std::int64_t row) { grid_.visit(column, row, visit); });
  }

  // The numbers, ascending, of the segments that may have a point in the box about `p` and `q`: all that have, and some more.
  std::vector<int> near(LatticePoint p, LatticePoint q) const;

  struct Nearest {
    int number = 0;
    vec2 point_mm{0.0, 0.0};
    double distance_mm = 0.0;
  };
  // The nearest part of a segment within the sector, of the segments for which accept(segment) holds. Of equally near ones
  // that with the lowest number.
  template <typename Accept>
  std::optional<Nearest> nearest_in(const Sector& sector, Accept accept) const {
    // Looks twice as far each time, so that in a crowd only the nearest are visited.
    std::optional<Nearest> best;
    if (segments_.empty() || grid_.is_empty(cells_of(sector, sector.radius()))) return best;
    for (double reach = std::min(2.0 * to_mm(cell_size()), sector.radius());; reach = std::min(2.0 * reach, sector.radius())) {
      grid_.visit_occupied(cells_of(sector, reach), [&](std::int64_t column, std::int64_t row) {
        const vec2 low = vec2{to_mm(column * cell_size()), to_mm(row * cell_size())};
        if (!sector.may_meet(low, low + to_mm(cell_size()), best ? best->distance_mm : sector.radius())) return;
        grid_.visit(column, row, [&](int number) {
          if (accept(segment(number))) improve(sector, number, best);
        });
      });
      if ((best && best->distance_mm <= reach) || reach >= sector.radius()) return best;
    }
  }

 private:
  // Coordinates of scenes fit 31 bits (geometry/lattice.h): half the memory, which in large panes is what a look costs.
  struct Kept {
    std::int32_t ax, ay, bx, by;
    int owner;
  };

  // A power of two of lattice units, so that the cell of a coordinate is a shift, exact and rounded down.
  std::int64_t cell_of(std::int64_t coordinate) const { return coordinate >> cell_bits_; }
  std::int64_t cell_size() const { return std::int64_t{1} << cell_bits_; }
  CellBox cells_of(const Sector& sector, double reach) const {
    const auto [low, high] = sector.bounds(reach);
    return cells_of(low, high);
  }
  CellBox cells_of(vec2 low, vec2 high) const {
    const auto cell = [this](double mm) { return cell_of(whole_below(mm * lattice_per_mm)); };
    return {cell(low.x), cell(low.y), cell(high.x), cell(high.y)};
  }
  // Calls visit(column, row) for every cell that the segment may touch: row by row, the columns of the part of the segment
  // within the row, widened by one lattice unit against the rounding of the division.
  template <typename Visit>
  void visit_cells(LatticePoint a, LatticePoint b, Visit visit) const {
    const LatticePoint low = a.y <= b.y ? a : b;
    const LatticePoint high = a.y <= b.y ? b : a;
    const auto x_at = [&](std::int64_t y) -> std::int64_t {
      if (y <= low.y) return low.x;
      if (y >= high.y) return high.x;
      const double share = static_cast<double>(y - low.y) / static_cast<double>(high.y - low.y);
      return low.x + std::llround(share * static_cast<double>(high.x - low.x));
    };
    const std::int64_t last_row = cell_of(high.y);
    for (std::int64_t row = cell_of(low.y); row <= last_row; ++row) {
      const std::int64_t x0 = x_at(row * cell_size());
      const std::int64_t x1 = x_at((row + 1) * cell_size());
      const std::int64_t last_column = cell_of(std::max(x0, x1) + 1);
      for (std::int64_t column = cell_of(std::min(x0, x1) - 1); column <= last_column; ++column) visit(column, row);
    }
  }
  void improve(const Sector& sector, int number, std::optional<Nearest>& best) const;

  int cell_bits_;
  GrowingStore<Kept> segments_;
  CellGrid grid_;
};

}  // namespace shatterpave::geometry
