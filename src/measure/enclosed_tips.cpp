#include "measure/enclosed_tips.h"

#include <cstddef>
#include <vector>

#include "geometry/planar_map.h"

namespace shatterpave::measure {

using glass::Crack;
using glass::CrackEnd;

EnclosedTips enclosed_tips(const glass::CrackNetwork& network, int impact) {
  std::vector<geometry::Segment> segments;
  // Of cracks that end in the glass: which segment has the tip.
  std::vector<const Crack*> crack_of_tip;
  for (const Crack& crack : network.cracks) {
    if (crack.impact != impact) continue;
    geometry::LatticePoint from = geometry::to_lattice(crack.points_mm.front());
    for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
      const geometry::LatticePoint to = geometry::to_lattice(crack.points_mm[i]);
      segments.push_back({from, to, crack.id});
      from = to;
    }
    crack_of_tip.resize(segments.size(), nullptr);
    const bool in_glass = crack.end.at == CrackEnd::At::enclosed || crack.end.at == CrackEnd::At::open;
    if (in_glass && !segments.empty()) crack_of_tip.back() = &crack;
  }
  EnclosedTips tips;
  for (const geometry::Face& face : geometry::faces(segments)) {
    for (const std::size_t spur : face.spurs) {
      const Crack* crack = crack_of_tip[spur];
      if (crack == nullptr) continue;
      ++tips.count;
      if (crack->end.at == CrackEnd::At::enclosed) ++tips.stopped_count;
    }
  }
  return tips;
}

}  // namespace shatterpave::measure
