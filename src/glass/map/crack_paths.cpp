#include "glass/map/crack_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/lattice.h"
#include "geometry/segment_distance.h"

namespace shatterpave::glass {

namespace {

// Of the root of the pane's area. By eye.
constexpr double largest_zone_share = 0.04;

double distance_to_outline(const geometry::Polygon& outline, vec2 point) {
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    distance = std::min(distance, geometry::distance_to_segment(point, outline[i], outline[(i + 1) % outline.size()]));
  }
  return distance;
}

// Ids of the cracks, each after the one that it ends on.
std::vector<int> order_of_precedence(const CrackNetwork& network) {
  std::vector<int> order;
  std::vector<bool> reached(network.cracks.size(), false);
  for (const Crack& crack : network.cracks) {
    std::vector<int> waiting;
    int id = crack.id;
    for (std::size_t at = network.index_of(id); !reached[at]; at = network.index_of(id)) {
      reached[at] = true;
      waiting.push_back(id);
      id = network.cracks[at].end.crack.value_or(id);
    }
    order.insert(order.end(), waiting.rbegin(), waiting.rend());
  }
  return order;
}

}  // namespace

std::vector<CrackPath> crack_paths(const CrackNetwork& network) {
  std::vector<CrackPath> result;
  std::map<geometry::LatticePoint, std::size_t> first_arms;
  for (const int id : order_of_precedence(network)) {
    const Crack& crack = network.crack(id);
    const geometry::LatticePoint start = geometry::to_lattice(crack.points_mm.front());
    const bool arm = crack.start.at == CrackEnd::At::ring;
    const auto other = arm ? first_arms.find(start) : first_arms.end();
    if (other != first_arms.end()) {
      CrackPath& path = result[other->second];
      path.points_mm.insert(path.points_mm.begin(), crack.points_mm.rbegin(), crack.points_mm.rend() - 1);
      path.start = crack.end;
      path.other_arm = id;
      first_arms.erase(other);
      continue;
    }
    if (arm) first_arms.emplace(start, result.size());
    result.push_back({crack.points_mm, id, std::nullopt, crack.start, crack.end});
  }
  return result;
}

std::vector<double> zone_limits_mm(const Pane& pane, const CrackNetwork& network) {
  std::vector<double> limits;
  for (std::size_t i = 0; i < network.impacts.size(); ++i) {
    const vec2 centre = network.impacts[i].at_mm;
    double room = largest_zone_share * std::sqrt(std::abs(geometry::area(pane.outline_mm)));
    room = std::min(room, 0.8 * distance_to_outline(pane.outline_mm, centre));
    for (std::size_t j = 0; j < network.impacts.size(); ++j) {
      if (j != i) room = std::min(room, 0.4 * glm::length(network.impacts[j].at_mm - centre));
    }
    limits.push_back(room);
  }
  return limits;
}

}  // namespace shatterpave::glass
