#include "measure/survey.h"

namespace shatterpave::measure {

ImpactFigures figures_of(const ImpactMeasures& measures) {
  ImpactFigures figures{measures.drawn,
                        measures.reaching_count,
                        measures.ends,
                        measures.ring_crack_count,
                        measures.held_ring_end_count,
                        {},
                        {},
                        {},
                        measures.gap_ratio,
                        measures.crossing_count};
  for (const double distance : measures.ring_distances_mm) figures.ring_distance_mm.add(distance);
  for (const Angle turn : measures.turns) figures.turn_deg.add(turn.degrees());
  for (const Angle angle : measures.edge_angles) figures.edge_angle_deg.add(angle.degrees());
  return figures;
}

}  // namespace shatterpave::measure
