// What is measured on one broken pane, as Agui et al. 1992, §3.1, measured photographs of theirs.
#pragma once

#include <optional>
#include <vector>

#include "core/angle.h"
#include "glass/network.h"
#include "glass/pane.h"
#include "measure/enclosed_tips.h"
#include "measure/pattern_measures.h"

namespace shatterpave::measure {

// How many cracks ended where (glass::CrackEnd).
struct EndCounts {
  int edge = 0;
  int crack = 0;
  int enclosed = 0;
  int open = 0;

  bool operator==(const EndCounts&) const = default;
};

// Of one impact: what was drawn for it (M, N and R), and what its cracks measure.
struct ImpactMeasures {
  glass::ImpactCounts drawn;
  int reaching_count = 0;                 // radial cracks that end on the edge: the paper's N, as it counted it
  EndCounts ends;                         // of all cracks
  int ring_crack_count = 0;               // ring cracks, two to a starting point
  int held_ring_end_count = 0;            // of them those that end on a radial crack or on the edge
  std::vector<double> ring_distances_mm;  // d_i (Fig. 4): of each feature point of the ring cracks from the impact
  double room_mm = 0.0;                   // from the impact to the nearest side of the pane
  std::vector<Angle> turns;               // θ_i (Fig. 3) along the large cracks
  std::vector<double> turn_distances_mm;  // of each of them from the impact
  Angle least_pixel_turn;                 // of θ_i along all radials, tracked by whole pixels: 0 or less
  Angle greatest_pixel_turn;              // 0 or more
  std::vector<Angle> edge_angles;         // of each crack that ends on the edge, in its order: see edge_angle
  std::vector<Angle> ring_end_angles;     // of each ring crack that ends on a radial, with it: see ring_end_angle
  std::vector<double> ring_strays;        // of each feature point of the ring cracks: d_i over d of the starting point, less 1
  std::optional<double> gap_ratio;        // of the radials beyond the ring: see gap_ratio
  int gap_count = 0;                      // between neighbouring radials where they leave the ring: see narrow_gap_radius_mm
  int narrow_gap_count = 0;               // of them those less than a quarter as wide as their mean
  std::optional<double> reaching_gap_variation;  // of the cracks that reach the edge (rule 2): see reaching_circle
  EnclosedTips enclosed_tips;                    // of a first impact whose cracks do not cross
  int crossing_count = 0;                        // crossings with cracks of this impact and of earlier ones; must be 0

  bool operator==(const ImpactMeasures&) const = default;
};

// What the figures of a pane may be held against.
enum class Subject {
  experiment,  // annealed glass by the paper's pattern: against the paper's nineteen panes
  rings,       // any other annealed or laminated glass: ends of ring cracks and crossings only
  dice,        // tempered glass: fragments and crossings only
};

struct PaneMeasures {
  std::vector<ImpactMeasures> impacts;  // in the order of the pane
  Subject subject = Subject::experiment;
  std::vector<double> fragment_counts = {};  // of tempered glass (measure/fragments.h)
  double least_fragment_count = 0.0;         // that EN 12150-1 wants of it
  std::optional<PatternMeasures> pattern;    // of annealed glass and Pattern::real

  bool operator==(const PaneMeasures&) const = default;
};

// Whether the `i`-th of the turns is one near the impact, or one farther out (rule 3): see young_turns_within.
bool is_young(const ImpactMeasures& measures, std::size_t i);
bool is_grown(const ImpactMeasures& measures, std::size_t i);

Subject subject_of(const glass::Pane& pane);

// `network` is what grew in `pane`. About a millisecond for a pane with M = 105, most of it for crossings and closed regions.
PaneMeasures measured(const glass::CrackNetwork& network, const glass::Pane& pane);

// The angle, 0 … 90°, between the side of the outline on which `crack` ends and the last chord of the crack, which runs from
// the last point on it that is a chord (measure/tracking.h) away from the tip as the crow flies, or from its start, to the tip.
Angle edge_angle(const glass::Crack& crack, const geometry::Polygon& outline_mm);

// The angle, 0 … 90°, between the end of a ring crack and the crack it ends on there, on a chord of 1.5 mm: shorter than a
// chord of the tracking, since a tip turns towards what it meets within the last millimetres.
//   ring  ends in a vertex of `met`, or near it
Angle ring_end_angle(const glass::Crack& ring, const glass::Crack& met);

// How evenly n >= 3 directions are spread: the variance of the gaps between neighbours, in units of that of as many directions
// drawn at random. 0: all gaps alike; 1: as if random; above 1: bundled. (With uniform directions the gaps follow a Dirichlet
// law, whose squared coefficient of variation is (n − 1)/(n + 1).)
double gap_ratio(std::vector<Angle> directions);

// Where the radial cracks of `impact` first come to be `radius_mm` away from it, as directions from it. Cracks that never do
// are left out.
std::vector<Angle> radial_directions(const glass::CrackNetwork& network, int impact, double radius_mm);

// The circle on which the angles between neighbouring cracks that reach the edge are measured (rule 2 of §3.1.3), SD over mean,
// where three or more do: of the room about the impact, so that all are there, and no edge has turned them yet.
inline constexpr double reaching_circle = 0.4;

// Turns as young as cracks are nearly straight (rule 3), and full-grown ones, by their distance in units of that room: by eye.
// Beyond, cracks turn towards the edge.
inline constexpr double young_turns_within = 1.0 / 6.0;
inline constexpr double grown_turns_from = 0.4;
inline constexpr double grown_turns_within = 0.8;

// The circle on which the spread of the radials is measured (rule 7 of §3.2): just beyond where rings lie, 1.3 (eq. 8) times
// the mean radius of M (eq. 2).
double spread_radius_mm(int radial_count);

// The circle on which narrow gaps between radials are counted: 10 mm beyond the mean radius of M.
double narrow_gap_radius_mm(int radial_count);

}  // namespace shatterpave::measure
