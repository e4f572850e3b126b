#include "paving/packing/packing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "paving/bonds/bond.h"
#include "paving/paved_areas.h"

namespace shatterpave::paving {
namespace {

// How far it is at the most from a place of a band about the area, so wide, to the nearest particle.
double farthest_mm(const std::vector<Particle>& particles, double side_mm, double band_mm) {
  double farthest = 0.0;
  for (double x = -band_mm; x <= side_mm + band_mm; x += 20.0) {
    for (double y = -band_mm; y <= side_mm + band_mm; y += 20.0) {
      const vec2 inside = glm::clamp(vec2{x, y}, 0.0, side_mm);
      if (glm::distance(inside, vec2{x, y}) > band_mm || inside == vec2{x, y}) continue;
      double nearest = 1e9;
      for (const Particle& p : particles) nearest = std::min(nearest, glm::distance(p.at, vec2{x, y}));
      farthest = std::max(farthest, nearest);
    }
  }
  return farthest;
}

// Cells at the border are cut from rows that go on beyond it, by two stones and more of those that lie there, whatever their
// size.
TEST(Packing, GoesOnBeyondTheBorderByStonesOfItsSize) {
  constexpr double side = 2000.0;
  for (const double size : {1.0, 0.5, 2.0}) {
    Pavement paved = pavement({{{0, 0}, {side, 0}, {side, side}, {0, side}}, {}}, 100, 0, BoundaryDirection{});
    if (size != 1.0) paved.sizes = SizesFromEdge{size, 1.0, 1500.0};
    const geometry::RegionIndex area(paved.area);
    const auto particles = packed_particles(paved, area, DirectionField(paved, area), SizeField(paved, area), 3);
    const double pitch = size * pitch_mm(paved).x;
    // Half the diagonal of a stone, and what rows are off there.
    EXPECT_LT(farthest_mm(particles, side, 2.0 * pitch), 1.1 * pitch) << size;
  }
}

}  // namespace
}  // namespace shatterpave::paving
