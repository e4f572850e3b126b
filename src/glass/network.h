// What growth makes of a pane: its cracks, as polylines in the plane.
#pragma once

#include <optional>
#include <vector>

#include "core/vec.h"

namespace shatterpave::glass {

// The numbers of cracks of an impact as they were drawn: M, N and R of the paper.
struct ImpactCounts {
  vec2 at_mm{0.0, 0.0};
  int radial_count = 0;
  int large_count = 0;
  int circular_count = 0;

  bool operator==(const ImpactCounts&) const = default;
};

enum class CrackKind {
  large,     // radial, meant to reach the edge
  radial,    // every other radial
  circular,  // one arm of a ring crack; the two arms of a starting point are two cracks
};

// Where a crack starts or ends.
struct CrackEnd {
  enum class At {
    impact,    // starts: at the impact
    ring,      // starts: at the starting point of a ring crack, which its two arms share
    edge,      // ends on the edge of the pane
    crack,     // ends on the crack with the id `crack`, in a vertex of its polyline
    enclosed,  // stopped within a region that cracks closed about it (§4.2.3 (2))
    open,      // growth ended before it met anything
  };
  At at = At::open;
  std::optional<int> crack;

  bool operator==(const CrackEnd&) const = default;
};

struct Crack {
  int id = 0;      // its index in the network
  int impact = 0;  // index of the impact it belongs to
  CrackKind kind = CrackKind::radial;
  std::vector<vec2> points_mm;  // two or more, distinct from one to the next, on the lattice, from start to tip
  CrackEnd start;
  CrackEnd end;

  bool operator==(const Crack&) const = default;
};

// Cracks do not cross: two of them meet only where one ends on the other, or where they start together.
struct CrackNetwork {
  std::vector<ImpactCounts> impacts;
  std::vector<Crack> cracks;

  bool operator==(const CrackNetwork&) const = default;
};

}  // namespace shatterpave::glass
