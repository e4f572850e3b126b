// A disc is seen whole in the tile that holds its middle if the band about the tile is as wide as its radius. Where a wider one
// is found, the tile is looked at again with a band that is twice as wide.
#include "measure/bare_spot.h"

#include <algorithm>
#include <vector>

#include "core/functions.h"
#include "core/parallel.h"
#include "measure/open_ground.h"
#include "paving/bonds/border.h"

namespace shatterpave::measure {

namespace {

using geometry::Box;
using geometry::Circle;
using geometry::Region;

constexpr double allowed_share = 0.1;
// Corners of 23° are still grown to their tips.
constexpr double miter_limit = 5.0;

double longest_side_mm(const paving::Pavement& pavement) {
  const double longer = paving::size_range(pavement).largest * std::max(pavement.stone_mm.x, pavement.stone_mm.y);
  if (pavement.border.course == paving::BorderCourse::none) return longer;
  const vec2 border = paving::border_stone_mm(pavement);
  return std::max({longer, border.x, border.y});
}

Circle widest(std::vector<Region> regions) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t r = 0; r < regions.size(); ++r) order.emplace_back(-geometry::area(regions[r]), r);
  std::ranges::sort(order);
  Circle widest;
  for (const auto& [minus_area, r] : order) {
    // No larger circle has room in less.
    if (pi * widest.radius * widest.radius >= -minus_area) break;
    const Circle circle = geometry::inscribed_circle(regions[r]);
    if (circle.radius > widest.radius) widest = circle;
  }
  return widest;
}

Circle widest_in_tile(const OpenGround& ground, const Box& tile, const Box& all, double band_mm) {
  while (true) {
    const vec2 band{band_mm, band_mm};
    const Circle circle = widest(ground.open({tile.low - band, tile.high + band}));
    const bool all_seen =
        glm::min(all.low, tile.low - band) == tile.low - band && glm::max(all.high, tile.high + band) == tile.high + band;
    if (all_seen || circle.radius < band_mm) return circle;
    band_mm *= 2.0;
  }
}

}  // namespace

double widest_allowed_spot_mm(const paving::Pavement& pavement) { return allowed_share * longest_side_mm(pavement); }

Circle widest_bare_spot(const paving::Pavement& pavement, const paving::StoneLayout& layout, const StoneIndex& index,
                        const geometry::RegionIndex& area) {
  const OpenGround ground(pavement, layout, index, area, {miter_limit, true, true});
  std::vector<Circle> of_tile(ground.tiles());
  const double band_mm = geometry::on_lattice(vec2{widest_allowed_spot_mm(pavement), 0.0}).x;
  parallel_for(of_tile.size(),
               [&](std::size_t t) { of_tile[t] = widest_in_tile(ground, ground.tile(t), area.box(), band_mm); });
  return *std::ranges::max_element(of_tile, {}, &Circle::radius);
}

}  // namespace shatterpave::measure
