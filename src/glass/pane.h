// What a scene may say of a pane of glass and of what hits it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/angle.h"
#include "geometry/polygon.h"

namespace shatterpave::glass {

// The law by which Rand of eq. 8 to 11 draws within [(1 - z) x, (1 + z) x].
enum class Spread { normal, uniform };

// The growth model of Agui et al. 1992, §4.2. Lengths are in px of the paper's lattice, one px being 300/640 mm on a pane
// of any size; one unit of time is the paper's dt = 1. Defaults are the paper's where it prints them.
struct Growth {
  Spread spread = Spread::normal;
  double spread_limit = 0.3;          // z of Rand (§4.3)
  double large_speed = 40.0;          // V1_ave, px per unit of time (eq. 9)
  double radial_speed = 10.0;         // V2_ave (eq. 10)
  double circular_speed = 10.0;       // V3_ave (eq. 11)
  Angle sector_angle = Angle::degrees(100.0);  // phi, the whole opening (§4.3)
  double sector_radius = 50.0;        // B, px (§4.3)
  Angle turn_limit = Angle::degrees(30.0);     // theta_th (eq. 18)
  double weight_time = 10.0;          // T (eq. 19)
  double time_step = 0.25;            // dt (eq. 16, 17)
  double circular_threshold = 70.0;   // A of eq. 3
  double circular_slope = 0.05;       // a of eq. 3, not printed
  double circular_offset = 0.5;       // b of eq. 3, not printed
  double large_slope = 0.0606;        // e of eq. 6 (eq. 1 misprints it)
  double large_offset = 3.293;        // f of eq. 6
  double ring_radius_slope_mm = 0.470;   // g of eq. 7
  double ring_radius_offset_mm = 13.90;  // h of eq. 7
  // Gains of the forces and the onset of the ring cracks, which the paper does not print, belong here too.

  bool operator==(const Growth&) const = default;
};

// Where something hits the pane, and how hard. Of the counts, those that are given win; the others follow from M.
struct Impact {
  vec2 at_mm{0.0, 0.0};                      // strictly inside the outline
  std::optional<double> mean_radial_count;   // M_ave of eq. 5, 1 … 10,000
  std::optional<int> radial_count;           // M, 1 … 10,000
  std::optional<int> large_count;            // N, 0 … M
  std::optional<int> circular_count;         // R, 0 … 1,000
  double ball_diameter_mm = 25.0;            // §3.1.1
  double speed_m_s = 6.26;                   // a fall from 2 m (§3.1.1)

  bool operator==(const Impact&) const = default;
};

struct Pane {
  std::string name;                // unique in its scene, an identifier: letters, digits, '_' and '-'
  geometry::Polygon outline_mm;    // simple, counter-clockwise, on the lattice
  double thickness_mm = 2.0;       // > 0
  std::vector<Impact> impacts;     // in the order in which they happened
  Growth growth;

  bool operator==(const Pane&) const = default;
};

}  // namespace shatterpave::glass
