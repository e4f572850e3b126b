// Points found by place: a k-d tree, which stays fast where points crowd, as the tips of cracks do about an impact.
#pragma once

#include <span>
#include <vector>

#include "geometry/sector.h"

namespace shatterpave::geometry {

class PointIndex {
 public:
  explicit PointIndex(std::span<const vec2> points);

  // The places in `points` of the at most `count` points in the sector that are nearest to its apex, nearest first, of equally
  // near ones that with the lower place first. Points that coincide with the apex are left out.
  std::vector<int> nearest_in(const Sector& sector, std::size_t count) const;

 private:
  struct Box {
    vec2 low;
    vec2 high;
  };
  struct Search;

  void build(std::size_t node, std::size_t first, std::size_t last);
  void search(std::size_t node, std::size_t first, std::size_t last, Search& search) const;

  std::span<const vec2> points_;
  std::vector<int> order_;  // places, so that each node holds a run of them
  std::vector<Box> boxes_;  // of the nodes; the children of node n are 2n + 1 and 2n + 2
};

}  // namespace shatterpave::geometry
