// The cracks of a network as the bodies that are made of them see them: in an order in which each may give way to the ones
// before it, and with the room that there is about the impacts.
#pragma once

#include <optional>
#include <vector>

#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// Glass that is left between a gap and the two faces of the pane.
inline constexpr double crack_skin_mm = 0.01;

// A crack, or the two arms of a ring crack as one, from end to end.
struct CrackPath {
  std::vector<vec2> points_mm;   // two or more
  int crack = 0;                 // id; of two arms, that of the one the path ends with,
  std::optional<int> other_arm;  // and of the other
  CrackEnd start;
  CrackEnd end;
};

// Each path comes after the one that it ends on: a crack gives way to the one it ran into.
std::vector<CrackPath> crack_paths(const CrackNetwork& network);

// The ground-up disc about an impact, which cracks do not enter.
struct ImpactZone {
  vec2 centre_mm{0.0, 0.0};
  double radius_mm = 0.0;
  double start_mm = 0.0;  // from the centre: where cracks of the impact itself start, unless a hole keeps them farther off

  bool operator==(const ImpactZone&) const = default;
};

// How wide (radius) the zone about each impact may be that cracks do not enter: at most 4 % of the root of the pane's area,
// clear of the outline and of the zones of the other impacts.
std::vector<double> zone_limits_mm(const Pane& pane, const CrackNetwork& network);

}  // namespace shatterpave::glass
