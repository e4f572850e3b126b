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
                        measures.crossing_count,
                        {},
                        {},
                        measures.reaching_gap_variation};
  for (const double distance : measures.ring_distances_mm) figures.ring_distance_mm.add(distance);
  for (std::size_t i = 0; i < measures.turns.size(); ++i) {
    const double turn = measures.turns[i].degrees();
    figures.turn_deg.add(turn);
    if (is_young(measures, i)) figures.young_turn_deg.add(turn);
    if (is_grown(measures, i)) figures.grown_turn_deg.add(turn);
  }
  for (const Angle angle : measures.edge_angles) figures.edge_angle_deg.add(angle.degrees());
  return figures;
}

}  // namespace shatterpave::measure
