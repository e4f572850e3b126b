// A region made ready for many questions: a tree of boxes over the segments of its border.
//
// Each answer takes time that grows as the logarithm of the number of border segments, whatever the extents.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/polygon.h"

namespace shatterpave::geometry {

class RegionIndex {
 public:
  // A piece of the border, in its direction: the region lies to its left.
  struct Segment {
    vec2 from{0.0, 0.0};
    vec2 to{0.0, 0.0};
  };
  struct Nearest {
    std::size_t segment = 0;
    vec2 point{0.0, 0.0};  // the nearest point of the border
    double distance_mm = 0.0;
  };

  // The region's vertices are taken to the lattice.
  explicit RegionIndex(const Region& region);

  const std::vector<Segment>& segments() const { return segments_; }
  Box box() const { return nodes_.front().box; }

  // Whether `point` lies inside the region or on its border; exact on the lattice.
  bool contains(vec2 point) const;
  // Whether a point of the border lies in the closed box.
  bool border_meets(const Box& box) const;
  // Whether a point of the border lies within `distance_mm` of `point`.
  bool border_within(vec2 point, double distance_mm) const;
  Nearest nearest(vec2 point) const;
  // Appends the segments with a point within `distance_mm` of `point`, in an order that is always the same but means nothing.
  void near(vec2 point, double distance_mm, std::vector<std::size_t>& found) const;

 private:
  // Children of node n with `count` 0 are n + 1 and `first`; a leaf holds segments [first, first + count).
  struct Node {
    Box box;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };

  void build(std::size_t begin, std::size_t end);

  std::vector<Segment> segments_;
  std::vector<Node> nodes_;
};

// The point of the segment nearest to `point`.
vec2 nearest_point(const RegionIndex::Segment& segment, vec2 point);

}  // namespace shatterpave::geometry
