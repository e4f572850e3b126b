#include "paving/packing.h"

#include <algorithm>
#include <cmath>

#include "geometry/lattice.h"
#include "paving/near_points.h"

namespace shatterpave::paving {

namespace {

// Beyond the border by pitches: a cell needs its neighbours and their neighbours to be whole.
constexpr double band_pitches = 2.6;

// Rows of one direction: the plain grid, anchored where the box about the area, turned into the rows' frame, has its lower
// left corner, so that whole stones start there.
std::vector<Particle> straight_rows(const Pavement& pavement, const geometry::RegionIndex& area, vec2 along) {
  const vec2 pitch = pitch_mm(pavement);
  const vec2 across = left_of(along);
  vec2 low{0.0, 0.0};
  for (std::size_t i = 0; i < area.segments().size(); ++i) {
    const vec2 p = area.segments()[i].from;
    const vec2 turned{glm::dot(p, along), glm::dot(p, across)};
    low = i == 0 ? turned : glm::min(low, turned);
  }
  const vec2 first = low + 0.5 * pitch;
  const Grid grid{first.x * along + first.y * across, pitch.x * along, pitch.y * across};
  std::vector<Particle> particles;
  for (const GridPoint& p : near_points(grid, area, band_pitches * std::max(pitch.x, pitch.y))) {
    particles.push_back({geometry::on_lattice(grid.at(p.i, p.j)), along});
  }
  return particles;
}

}  // namespace

std::vector<Particle> packed_particles(const Pavement& pavement, const geometry::RegionIndex& area, const DirectionField& field,
                                       std::uint64_t seed) {
  static_cast<void>(seed);
  return straight_rows(pavement, area, field.axis(0.5 * (area.box().low + area.box().high)));
}

}  // namespace shatterpave::paving
