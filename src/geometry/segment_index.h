// Segments found by place: a uniform grid, so that a question costs what lies near, however many segments there are elsewhere.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "geometry/lattice.h"
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
  // Cells are squares of `cell_mm` > 0. Best near the length of a typical segment.
  explicit SegmentIndex(double cell_mm);

  // The number of the new segment. Numbers are never used twice.
  int add(const Segment& segment);
  void remove(int number);
  // Adds every segment of `other`, removed ones too.
  void add_all(const SegmentIndex& other);
  const Segment& segment(int number) const { return segments_[static_cast<std::size_t>(number)]; }

  // The numbers, ascending, of the segments that may have a point in the box about `p` and `q`: all that have, and some more.
  std::vector<int> near(LatticePoint p, LatticePoint q) const;

  struct Nearest {
    int number = 0;
    vec2 point_mm{0.0, 0.0};
    double distance_mm = 0.0;
  };
  // The nearest part of a segment within the sector, of the segments that `owner` does not own. Of equally near ones that
  // with the lowest number.
  std::optional<Nearest> nearest_in(const Sector& sector, int owner) const;

 private:
  using Cell = std::vector<int>;

  std::int64_t cell_of(std::int64_t coordinate) const;
  const Cell* cell(std::int64_t column, std::int64_t row) const;
  template <typename Visit>
  void visit_cells(const Segment& segment, Visit visit) const;
  void improve(const Sector& sector, int owner, const Cell& cell, std::optional<Nearest>& best) const;

  std::int64_t cell_size_;  // lattice units
  std::vector<Segment> segments_;
  std::unordered_map<std::uint64_t, Cell> cells_;  // only ever looked up, never walked
};

}  // namespace shatterpave::geometry
