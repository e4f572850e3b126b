// An index of moving points by their places.
#pragma once

#include <span>
#include <vector>

#include "geometry/cell_grid.h"
#include "geometry/polygon.h"
#include "geometry/sector.h"

namespace shatterpave::geometry {

class PointIndex {
 public:
  // Cells are squares of `cell_mm` > 0: best where few points share one.
  explicit PointIndex(double cell_mm) : cells_per_mm_(1.0 / cell_mm) {}

  // Puts the point `number` >= 0 there, wherever it was before. Numbers should be dense.
  void put(int number, vec2 at_mm);
  void remove(int number);
  vec2 at(int number) const { return points_[static_cast<std::size_t>(number)]; }

  struct Found {
    int number = 0;
    double distance2 = 0.0;  // square of its distance from the apex

    bool operator<(const Found& other) const {
      return distance2 != other.distance2 ? distance2 < other.distance2 : number < other.number;
    }
  };
  // Fills `found` with the points in the sector that are nearest to its apex, nearest first, of equally near ones that with
  // the lower number first, and returns how many there are. Points that coincide with the apex are left out.
  std::size_t nearest_in(const Sector& sector, std::span<Found> found) const;

  // Calls visit(number) for every point in the box and for some about it.
  template <typename Visit>
  void visit_in(const Box& box, Visit visit) const {
    grid_.visit_occupied(cells_of(box.low, box.high),
                         [&](std::int64_t column, std::int64_t row) { grid_.visit(column, row, visit); });
  }

 private:
  std::int64_t cell_of(double coordinate) const { return whole_below(coordinate * cells_per_mm_); }
  CellBox cells_of(vec2 low, vec2 high) const { return {cell_of(low.x), cell_of(low.y), cell_of(high.x), cell_of(high.y)}; }
  std::size_t nearest_within(const Sector& sector, double reach, std::span<Found> found) const;

  double cells_per_mm_;
  std::vector<vec2> points_;
  std::size_t count_ = 0;  // of points that have a place
  CellGrid grid_;
};

}  // namespace shatterpave::geometry
