// The faces into which cracks divide the plane, from their polylines alone: the slow and independent answer to what a region
// closed by cracks is.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/lattice.h"

namespace shatterpave::glass {

// REQUIRES polylines of which no two touch but in common vertices, as `faults` of network_oracle.h checks. The edge of the pane
// is no crack and closes nothing.
class CrackFaces {
 public:
  using Polyline = std::vector<geometry::LatticePoint>;

  explicit CrackFaces(std::span<const Polyline> cracks);

  // Whether cracks surround the place in the middle between two points of the lattice, which lies on no crack.
  bool surround_middle(geometry::LatticePoint p, geometry::LatticePoint q) const;
  // Whether cracks surround all that lies about the point.
  bool surround(geometry::LatticePoint p) const;
  // How many closed regions there are; one with others inside it counts as one.
  int count() const { return count_; }

 private:
  // One side of a piece of a crack: from its vertex on, with the face on the left.
  struct Dart {
    std::size_t from = 0;
    std::size_t to = 0;
  };
  // A walk about a face, which stays on its left.
  struct Walk {
    std::vector<std::size_t> darts;
    bool is_outer = false;  // about the outside of what hangs together
  };

  std::size_t vertex(geometry::LatticePoint p) const;
  void add_pieces(std::span<const Polyline> cracks);
  void add_walks();
  bool odd_outer_walk(geometry::LatticePoint p, std::size_t but) const;

  std::vector<geometry::LatticePoint> vertices_;   // ascending; coordinates are doubled
  std::vector<Dart> darts_;                        // 2 i and 2 i + 1 are the two sides of piece i
  std::vector<std::vector<std::size_t>> leaving_;  // of each vertex, counter-clockwise
  std::vector<Walk> walks_;
  std::vector<std::size_t> walk_of_;  // of each dart
  int count_ = 0;
};

}  // namespace shatterpave::glass
