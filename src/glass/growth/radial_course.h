// The radials of real panes (Pattern::real): which of them die on the way out, where, and where they kink.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/angle.h"
#include "core/random.h"
#include "glass/network.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// A radial turns by `turn` where it comes to be `radius_mm` away from the impact.
struct Kink {
  double radius_mm = 0.0;
  Angle turn;
};

// What is drawn for a radial before it grows.
struct RadialCourse {
  bool large = false;  // meant to reach the edge
  Angle direction;
  double reach_mm = std::numeric_limits<double>::infinity();  // where it gives up; large: nowhere
  bool arrests = false;                                       // it stops there, in the glass, instead
  Angle veer;                                                 // by which it turns there, else
  double sweep_per_mm = 0.0;                                  // radians by which it bends all along
  double speed_share = 1.0;                                   // of the speed of radials
  std::vector<Kink> kinks;                                    // from the impact outwards
};

// The radii of the pane's rings that lie within `farthest_mm`. The first is, where the scene does not say, that share of the
// root of the pane's area: what bends when it is hit is larger in a larger pane. By eye.
inline constexpr double first_ring_share = 0.1;
std::vector<double> ring_radii(const Pane& pane, double farthest_mm);

// By how much the piece of ring `ring` to the left of radial `radial` lies off its ring, as a share of its radius; and whether
// it and the piece on the other side of that radial end in two places.
double piece_offset(const Rings& rings, std::uint64_t seed, Id impact, int ring, int radial);
bool is_staggered(std::uint64_t seed, Id impact, int ring, int radial);
// Where the pieces on both sides of a radial meet, as a share of the ring's radius off it; one that is staggered keeps to its
// own.
double joint_offset(const Rings& rings, std::uint64_t seed, Id impact, int ring, int radial, int radial_before);

// One course to a radial, counter-clockwise, for the counts of an impact.
//   crushed_mm   radius of the crushed zone, > 0
//   first_mm     > 0: none dies nearer to the impact
//   room_mm      from the impact to the nearest point of the edge
//   farthest_mm  to the farthest
// Directions are those of equal angles, each off by chance. As many radials are left at a distance r, of the M at 1.2 radii of
// the crushed zone, as go with the power −0.3 of r, but never fewer than the N large ones: 23 : 16.5 : 13 at 1.2, 4 and 8
// radii, as counted in photographs of a hit by something blunt. Who dies is drawn, the more shielded of two each time.
std::vector<RadialCourse> radial_courses(const Pane& pane, const ImpactCounts& counts, std::uint64_t seed, Id impact,
                                         double crushed_mm, double first_mm, double room_mm, double farthest_mm);

}  // namespace shatterpave::glass
