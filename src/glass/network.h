// What growth makes of a pane: its cracks, as polylines in the plane.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/vec.h"

namespace shatterpave::glass {

// What an impact does to the glass about it, besides cracks: circles about the impact, which may reach beyond the edge.
struct Crater {
  double crushed_radius_mm = 0.0;  // glass ground to powder, right through
  double near_radius_mm = 0.0;     // spall on the side of the impact, >= the former
  double far_radius_mm = 0.0;      // spall on the other side, a cone's wider end: >= the former
  double milky_radius_mm = 0.0;    // laminated glass: white with fine cracks as far as here; 0: nowhere

  bool operator==(const Crater&) const = default;
};

// The numbers of cracks of an impact as they were drawn: M, N and R of the paper.
struct ImpactCounts {
  vec2 at_mm{0.0, 0.0};
  int radial_count = 0;
  int large_count = 0;
  int circular_count = 0;
  std::optional<Crater> crater{};  // none in the paper's model

  bool operator==(const ImpactCounts&) const = default;
};

enum class CrackKind {
  large,     // radial, meant to reach the edge
  radial,    // every other radial
  circular,  // one arm of a ring crack; the two arms of a starting point are two cracks
  branch,    // leaves a radial crack, or another branch, which goes on
  dice,      // a border of the fragments of tempered glass
  rung,      // one of two arms across the strip between two radials, as circular ones are, but on no ring
  chip,      // the border of a lens-shaped flake beside a radial crack
};

// Where a crack starts or ends.
struct CrackEnd {
  enum class At {
    impact,    // starts: at the impact
    ring,      // starts: at the starting point of a ring crack, which its two arms share
    origin,    // starts, dice: within the glass, where no crack was yet
    edge,      // ends on the edge of the pane
    crack,     // starts or ends on the crack with the id `crack`, in a vertex of its polyline
    enclosed,  // stopped within a region that cracks closed about it (§4.2.3 (2))
    open,      // growth ended before it met anything
  };
  At at = At::open;
  std::optional<int> crack;

  bool operator==(const CrackEnd&) const = default;
};

// Where a crack that still grows will end, and how far that is from its tip.
struct CrackRest {
  CrackEnd::At end = CrackEnd::At::open;
  double way_mm = 0.0;

  bool operator==(const CrackRest&) const = default;
};

struct Crack {
  int id = 0;      // its number among all cracks of the pane, once all have grown: where all are there, its index
  int impact = 0;  // index of the impact it belongs to
  CrackKind kind = CrackKind::radial;
  std::vector<vec2> points_mm;  // two or more, distinct from one to the next, on the lattice, from start to tip
  CrackEnd start;
  CrackEnd end;
  bool through = true;  // whether it runs from face to face; not so: a chip, and in laminated glass what is in one of the two
                        // sheets only
  std::vector<double> times_us{};  // when the tip came to each point, after the pane's zero of time; never falling. Empty where
                                   // nobody asked (glass/breaking.h)
  std::optional<CrackRest> rest{};  // of a crack that is cut off at its tip (map/growth_clock.h): what is to come. Its end is
                                    // `open` until then

  bool operator==(const Crack&) const = default;
};

// Cracks do not cross: two of them meet only where one starts or ends on the other, or where they start together.
struct CrackNetwork {
  std::vector<ImpactCounts> impacts;
  std::vector<Crack> cracks;  // by ascending ids

  // The place in `cracks` of the crack with the id, which must be there.
  std::size_t index_of(int id) const;
  const Crack& crack(int id) const { return cracks[index_of(id)]; }

  bool operator==(const CrackNetwork&) const = default;
};

inline std::size_t CrackNetwork::index_of(int id) const {
  const auto expected = static_cast<std::size_t>(id);
  if (expected < cracks.size() && cracks[expected].id == id) return expected;
  const auto found = std::ranges::lower_bound(cracks, id, {}, &Crack::id);
  return static_cast<std::size_t>(found - cracks.begin());
}

// How a crack will end when it has grown.
inline CrackEnd::At end_in_time(const Crack& crack) { return crack.rest ? crack.rest->end : crack.end.at; }

}  // namespace shatterpave::glass
