// How well stones are laid: exact faults by brute force on the lattice, an oracle for measure/layout_faults.h; and what
// measure/pavement_measures.h tells, as shares.
#pragma once

#include <cstddef>

#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::paving {

struct LayoutFaults {
  std::size_t invalid = 0;   // outline not simple, not counter-clockwise, with repeated or redundant vertices, off the lattice
  std::size_t overlaps = 0;  // pairs of stones with a point in common
  std::size_t outside = 0;   // stones that leave the area or enter a hole

  std::size_t total() const { return invalid + overlaps + outside; }
};

// Every pair of stones whose boxes meet is tested, every side against every side of the border near it; all exact.
LayoutFaults faults(const Pavement& pavement, const StoneLayout& layout);

struct LayoutQuality {
  std::size_t stones = 0;
  std::size_t whole = 0;
  double mean_misalignment_deg = 0.0;  // sides of whole stones against the field, weighted by length
  double p95_misalignment_deg = 0.0;
  double four_sided = 0.0;  // share of the whole stones with four corners
  double coverage = 0.0;    // share of the area under the stones grown by half a joint
  double joint_p5 = 0.0;    // width of the joint beside whole stones, over the asked one
  double joint_p95 = 0.0;
  double area_spread = 0.0;  // standard deviation over mean of the areas of whole stones, of any bond
  double mean_area = 0.0;    // of whole stones, over stone_mm.x * stone_mm.y
  double smallest = 0.0;     // least area of a stone over that of the asked one
};

LayoutQuality quality(const Pavement& pavement, const StoneLayout& layout);

}  // namespace shatterpave::paving
