// The measured panes that generated ones are held against: Agui et al. 1992, §3.1, Table 1 and eq. 1 and 2. 300 × 300 × 2 mm,
// hit in the middle by a steel ball of 25 mm after a fall from 2 m.
#pragma once

#include <optional>
#include <span>

#include "measure/line.h"

namespace shatterpave::measure {

// One of the nineteen panes.
struct ExperimentPane {
  int radial_count = 0;                  // M
  int large_count = 0;                   // N, those that reach the edge
  std::optional<double> ring_radius_mm;  // d_ave, of panes with ring cracks
};

// Table 1, cr_1 … cr_19.
std::span<const ExperimentPane> experiment_panes();

// N against M, fitted to Table 1: N = 0.0615 M + 3.06, residual 1.14. (Eq. 1 prints the slope as 0.606, a misprint.)
Line experiment_large_line();

// d_ave against M of eq. 2, without cr_1 and cr_4, which lie far off as the paper says: d_ave = 0.470 M + 13.90 mm.
inline constexpr double ring_radius_slope_mm = 0.470;
inline constexpr double ring_radius_offset_mm = 13.90;
inline constexpr double experiment_ring_radius_mm(double radial_count) {
  return ring_radius_slope_mm * radial_count + ring_radius_offset_mm;
}

// The range of turns that the paper observed (§3.1.3, Fig. 5), degrees.
inline constexpr double least_turn_deg = -22.5;
inline constexpr double greatest_turn_deg = 27.5;

// The range of a ring crack's radius in units of its mean: 1 ± z with z = 0.3 (eq. 8, §4.3).
inline constexpr double least_ring_ratio = 0.7;
inline constexpr double greatest_ring_ratio = 1.3;

}  // namespace shatterpave::measure
