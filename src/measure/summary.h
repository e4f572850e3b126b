// What many panes measure together, held against the measured panes of Agui et al. 1992.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "measure/distribution.h"
#include "measure/finding.h"
#include "measure/line.h"
#include "measure/pane_measures.h"
#include "measure/pattern_totals.h"

namespace shatterpave::measure {

// Turns are told in bands of this width, by their distance from the impact.
inline constexpr double turn_band_mm = 12.5;

// The figures against the measured panes are of each pane's first impact: the cracks of later ones stop at earlier ones, and no
// pane of the paper was hit twice. Crossings are those of all impacts.
// Of annealed panes of Pattern::real there are findings of their own (PatternTotals), if there are any.
// Of panes that are not of the paper's kind (Subject) nothing is held against its panes: only crossings and ends of ring cracks
// are added up, or crossings and fragments; where there are no others, the findings against the paper's panes are open.
struct Summary {
  Distribution radial_count;                                       // M as drawn
  Line large_line;                                                 // N that reach the edge, against M
  Line ring_line;                                                  // d_ave of panes with ring cracks, mm, against M
  Distribution ring_offset_mm;                                     // of d_ave from eq. 2
  Distribution ring_ratio;                                         // d_i / (d_ave of eq. 2)
  Histogram ring_ratios{0.0, 0.05, std::vector<std::size_t>(40)};  // 0 … 2
  Distribution turn_deg;                                           // θ
  Histogram turns_deg{-45.0, 1.25, std::vector<std::size_t>(72)};  // ±45°, so that cells end at −22.5° and 27.5°
  std::array<Distribution, 16> turns_deg_by_distance;              // θ from 0 … 12.5 mm from the impact on (turn_band_mm)
  Distribution reaching_gap_variation;                             // of the angles between cracks that reach the edge
  Distribution edge_angle_deg;
  Histogram edge_angles_deg{0.0, 2.5, std::vector<std::size_t>(36)};  // 0 … 90°
  Distribution gap_ratio;
  EndCounts ends;
  std::vector<Finding> findings;
};

// Adds panes up, one after another. The result depends on their order, in the last bits.
class Totals {
 public:
  void add(const PaneMeasures& pane);
  // Of all panes so far.
  Summary summary() const;

 private:
  void add_rings(const ImpactMeasures& impact);
  void add_turns(const ImpactMeasures& impact);
  void add_pixel_turns(const ImpactMeasures& impact);
  void add_young_findings(std::vector<Finding>& findings) const;
  void add_rule_findings(std::vector<Finding>& findings) const;

  Summary sums_;  // but its lines and findings
  std::vector<vec2> large_points_;
  std::vector<vec2> ring_points_;
  std::size_t turns_in_range_ = 0;
  std::size_t left_turns_ = 0;  // counter-clockwise
  std::size_t ring_ends_ = 0;
  std::size_t held_ring_ends_ = 0;
  std::size_t square_edge_angles_ = 0;
  std::size_t crossings_ = 0;
  std::size_t squares_ = 0;  // in which fragments of tempered glass were counted
  std::size_t coarse_squares_ = 0;
  std::size_t impacts_ = 0;
  // Six panes in succession that are like cr_1 … cr_6: how many there are of the next six, and the extremes of their turns.
  int in_six_ = 0;
  double least_of_six_deg_ = 0.0;
  double greatest_of_six_deg_ = 0.0;
  Distribution turn_extreme_deg_;  // of each six: half of the way from the least turn to the greatest
  Distribution young_turn_deg_;    // of turns near the impacts (young_turns_within)
  Distribution grown_turn_deg_;
  std::size_t enclosed_tips_ = 0;
  std::size_t stopped_tips_ = 0;
  std::size_t gaps_ = 0;
  std::size_t narrow_gaps_ = 0;
  std::size_t ring_end_angles_ = 0;
  std::size_t square_ring_end_angles_ = 0;
  Distribution ring_stray_;
  PatternTotals pattern_;  // of panes of Pattern::real
};

// The finding with that id, which must be one of them.
const Finding& finding(const Summary& summary, std::string_view id);

}  // namespace shatterpave::measure
