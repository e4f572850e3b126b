#include "glass/growth/tip.h"

#include "geometry/lattice.h"
#include "glass/growth/counts.h"
#include "glass/growth/crater.h"

namespace shatterpave::glass {

ImpactState initial_state(const Pane& pane, int impact, std::uint64_t seed) {
  const Impact& cause = pane.impacts[static_cast<std::size_t>(impact)];
  const Growth& growth = pane.growth;
  ImpactState state;
  state.index = impact;
  state.id = Id(pane.name).child("impact").child(static_cast<std::uint64_t>(impact));
  state.at_mm = geometry::on_lattice(cause.at_mm);
  state.counts = drawn_counts(cause, growth, seed, state.id);
  if (pane.pattern == Pattern::real) state.counts.circular_count = 0;
  if (makes_crater(pane)) state.counts.crater = crater_of(cause, pane);
  // Eq. 4, 7, 8.
  const int r = state.counts.circular_count;
  const double mean_mm = growth.ring_radius_slope_mm * state.counts.radial_count + growth.ring_radius_offset_mm;
  const Id rings = state.id.child("ring");
  const double phase = uniform(seed, {Stream::first_direction, rings});
  for (int i = 0; i < r; ++i) {
    const Id ring = rings.child(static_cast<std::uint64_t>(i));
    state.waiting.push_back(
        {i, Angle::radians(2.0 * pi * (phase + i) / r), spread_about(mean_mm, growth, seed, {Stream::ring_radius, ring})});
  }
  return state;
}

}  // namespace shatterpave::glass
