// What a tile of the open ground and the band about it, as wide as the disc's radius, leave uncovered is shrunk by that radius:
// what remains are the places within the tile where the middle of a disc may be. Those of neighbouring tiles that touch are one
// hole.
#include "measure/coverage.h"

#include <algorithm>

#include "core/functions.h"
#include "core/parallel.h"
#include "geometry/clip.h"
#include "geometry/corners.h"
#include "measure/open_ground.h"

namespace shatterpave::measure {

namespace {

using geometry::Box;
using geometry::Polygon;
using geometry::Region;

// Of a stone's shorter side: half of a quarter.
constexpr double disc_radius = 0.125;

double area_within(const Box& box, const Region& region) {
  const Box about = geometry::bounding_box(region.outline);
  if (glm::min(about.low, box.low) == box.low && glm::max(about.high, box.high) == box.high) return geometry::area(region);
  double sum = 0.0;
  for (const Region& part : geometry::intersection(geometry::rectangle(box), region)) sum += geometry::area(part);
  return sum;
}

struct TileCoverage {
  double uncovered_mm2 = 0.0;
  std::vector<Polygon> disc_middles;
};

TileCoverage covered(const OpenGround& ground, const Box& tile, double radius_mm) {
  TileCoverage result;
  for (const Region& open : ground.open({tile.low - vec2{radius_mm, radius_mm}, tile.high + vec2{radius_mm, radius_mm}})) {
    result.uncovered_mm2 += area_within(tile, open);
    if (geometry::area(open) < pi * radius_mm * radius_mm) continue;
    for (Region& middles : geometry::offset(open, -radius_mm)) result.disc_middles.push_back(std::move(middles.outline));
  }
  return result;
}

}  // namespace

Coverage coverage_of(const paving::Pavement& pavement, const paving::StoneLayout& layout, const StoneIndex& index,
                     const geometry::RegionIndex& area) {
  const OpenGround ground(pavement, layout, index, area, {});
  const double radius_mm =
      disc_radius * paving::size_range(pavement).smallest * std::min(pavement.stone_mm.x, pavement.stone_mm.y);
  std::vector<TileCoverage> parts(ground.tiles());
  parallel_for(parts.size(), [&](std::size_t t) { parts[t] = covered(ground, ground.tile(t), radius_mm); });
  double uncovered = 0.0;
  std::vector<Polygon> middles;
  for (TileCoverage& part : parts) {
    uncovered += part.uncovered_mm2;
    for (Polygon& polygon : part.disc_middles) middles.push_back(std::move(polygon));
  }
  Coverage result;
  result.share = 1.0 - uncovered / geometry::area(pavement.area);
  for (const Region& hole : geometry::united(middles)) result.holes.push_back(geometry::centroid(hole.outline));
  return result;
}

}  // namespace shatterpave::measure
