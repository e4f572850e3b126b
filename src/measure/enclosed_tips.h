// Tips within regions that cracks closed: what the second stop rule of Agui et al. 1992, §4.2.3, is about.
#pragma once

#include "glass/network.h"

namespace shatterpave::measure {

struct EnclosedTips {
  int count = 0;          // of cracks that end in the glass, on nothing, within a region that cracks close without the edge
  int stopped_count = 0;  // of them those that stopped when it closed; the others were left, or ran on, until growth ended

  bool operator==(const EnclosedTips&) const = default;
};

// Of the cracks of one impact, and of regions that they close. No two of them may cross.
EnclosedTips enclosed_tips(const glass::CrackNetwork& network, int impact);

}  // namespace shatterpave::measure
