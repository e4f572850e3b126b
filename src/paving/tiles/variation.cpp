// A stone's new place is an affine map of its outline. Under one no point moves farther than the corner that moves most, so it
// is enough to hold the corners back: where one would go too far, the whole movement is scaled down.
#include "paving/tiles/variation.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/random.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"

namespace shatterpave::paving {

namespace {

// Rounding of both faces to the lattice, and of the cells that they are of, with some room.
constexpr double hairline_mm = 0.01;

geometry::Polygon moved(const geometry::Polygon& outline, const Pavement& pavement, double bulge, std::uint64_t seed, Id id) {
  const Variation& variation = pavement.variation;
  const auto draw = [&](std::uint32_t index) { return 2.0 * uniform(seed, {Stream::stone_place, id, index}) - 1.0; };
  const double scale = 1.0 + variation.size * draw(0);
  const Angle turn = variation.rotation * draw(1);
  const vec2 offset = variation.offset_mm * vec2{draw(2), draw(3)};
  const vec2 middle = geometry::centroid(outline);
  std::vector<vec2> steps;
  steps.reserve(outline.size());
  double farthest = 0.0;
  for (const vec2& p : outline) {
    steps.push_back(middle + scale * rotated(p - middle, turn) + offset - p);
    farthest = std::max(farthest, std::sqrt(glm::dot(steps.back(), steps.back())));
  }
  const double own_part = 0.5 - bulge;
  const double most = std::max(0.0, own_part * pavement.joint_mm - hairline_mm);
  const double part = farthest > most ? most / farthest : 1.0;
  geometry::Polygon result(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i) result[i] = geometry::on_lattice(outline[i] + part * steps[i]);
  result = geometry::cleaned(result);
  return geometry::is_simple(result) && geometry::area(result) > 0.0 ? result : outline;
}

}  // namespace

StoneLayout varied(StoneLayout layout, const Pavement& pavement, double bulge, std::uint64_t seed) {
  const Variation& variation = pavement.variation;
  const auto id_of = [&](const Stone& stone) { return Id(pavement.name).child(static_cast<std::uint64_t>(stone.id)); };
  if (variation.size > 0.0 || variation.rotation > Angle() || variation.offset_mm > 0.0) {
    parallel_for(layout.stones.size(), [&](std::size_t s) {
      Stone& stone = layout.stones[s];
      stone.outline_mm = moved(stone.outline_mm, pavement, bulge, seed, id_of(stone));
    });
  }
  if (variation.missing > 0.0) {
    std::erase_if(layout.stones, [&](const Stone& stone) {
      return uniform(seed, {Stream::stone_missing, id_of(stone)}) < variation.missing;
    });
  }
  return layout;
}

}  // namespace shatterpave::paving
