#include "geometry/needles.h"

#include <algorithm>
#include <iterator>

#include "geometry/clip.h"

namespace shatterpave::geometry {

namespace {

constexpr double about_mm = 0.002;
constexpr double sharpest_rad = 0.001;

void append_needles(const Polygon& ring, std::vector<std::vector<vec2>>& needles) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const vec2 before = ring[(i + n - 1) % n];
    const vec2 after = ring[(i + 1) % n];
    const vec2 in = ring[i] - before;
    const vec2 out = after - ring[i];
    // The region lies to the left: a turn to the right is one of what reaches into it.
    const double turn = cross(in, out);
    if (turn < 0.0 && glm::dot(in, out) < 0.0 && -turn < sharpest_rad * -glm::dot(in, out))
      needles.push_back({before, ring[i], after});
  }
}

// Of border that a region without slivers loses when it is drawn in, in units of their width. By eye: more than corners do,
// less than a spike ten times as long as wide.
constexpr double border_lost = 10.0;

}  // namespace

std::vector<Region> without_slivers(const std::vector<Region>& regions, double width_mm) {
  std::vector<Region> result;
  for (const Region& region : regions) {
    const std::vector<Region> cores = offset(region, -0.5 * width_mm);
    if (cores.size() != 1) {
      for (const Region& core : cores) std::ranges::move(offset(core, 0.5 * width_mm), std::back_inserter(result));
    } else if (perimeter(cores.front()) > perimeter(region) - border_lost * width_mm) {
      result.push_back(region);
    } else {
      // Grown by more than it was drawn in, the core cuts off spikes alone.
      for (const Region& grown : offset(cores.front(), width_mm)) {
        std::ranges::move(intersection(region, grown), std::back_inserter(result));
      }
    }
  }
  return result;
}

Region without_needles(const Region& region) {
  std::vector<std::vector<vec2>> needles;
  append_needles(region.outline, needles);
  for (const Polygon& hole : region.holes) append_needles(hole, needles);
  if (needles.empty()) return region;
  std::vector<Region> left = difference(region, thickened(needles, about_mm));
  return left.size() == 1 ? std::move(left.front()) : region;
}

}  // namespace shatterpave::geometry
