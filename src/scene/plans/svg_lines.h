// Outlines that a drawing gives line by line.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/plans/plan.h"

namespace shatterpave::scene {

// An open line of a drawing that may be part of an outline.
struct OutlinePiece {
  std::optional<std::size_t> group;  // the feature in which it lies
  std::size_t line = 0;              // its shape
  std::optional<std::size_t> area;   // the shape that its element fills by itself
};

// Adds to the plan an area for each group whose pieces meet end to end, within `tolerance_mm`, in rings: all of them, filled by
// the even-odd rule. Pieces that end nowhere are left out; where three or more meet it is not clear which belong together, and
// all that hang together with these make no ring.
void join_lines(const std::vector<OutlinePiece>& pieces, double tolerance_mm, Plan& plan);

}  // namespace shatterpave::scene
