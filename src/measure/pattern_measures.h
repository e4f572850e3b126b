// What is measured on a pane of pattern "real", against photographs of broken panes.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/angle.h"
#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::measure {

// Distances from the impact at which radials are counted, in radii of the crushed zone: at its edge, midway and outside.
inline constexpr std::array<double, 3> counting_radii = {1.2, 4.0, 8.0};

// A piece of the pane: a face of its cracks.
struct PieceMeasures {
  double area_mm2 = 0.0;
  double distance_mm = 0.0;  // of its middle from the impact
  double elongation = 1.0;   // long over short axis of the ellipse with its second moments, >= 1
  double solidity = 1.0;     // its area over that of its convex hull
  bool at_edge = false;      // the pane's edge bounds it

  bool operator==(const PieceMeasures&) const = default;
};

// Of the first impact.
struct PatternMeasures {
  std::array<int, 3> radial_counts{};   // at counting_radii
  std::optional<double> gap_variation;  // SD over mean of the angles between neighbouring radials, midway
  int joint_count = 0;                  // where a ring meets a radial from both sides
  int staggered_count = 0;              // of them those where its two pieces end in different places
  int sector_count = 0;                 // between neighbouring radials on a ring
  int gap_count = 0;                    // of them those that a ring leaves out
  std::vector<double> ring_variations;  // SD over mean of the radius of each ring of six pieces or more
  std::vector<double> kinks_deg;        // of radials, in vertices where a ring meets them: absolute
  int chip_count = 0;
  double first_ring_mm = 0.0;         // radius of the first ring; 0: there is none
  double room_mm = 0.0;               // from the impact to the nearest side of the pane
  std::vector<PieceMeasures> pieces;  // above least_piece_mm2

  bool operator==(const PatternMeasures&) const = default;
};

inline constexpr double least_piece_mm2 = 1.0;

// SD over mean of the angles between neighbours, round the circle. REQUIRES two directions or more.
double gap_variation(std::vector<Angle> directions);

// `network` is that of the pane, which has an impact.
PatternMeasures pattern_measures(const glass::CrackNetwork& network, const glass::Pane& pane);

}  // namespace shatterpave::measure
