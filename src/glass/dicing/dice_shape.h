// How large the fragments of tempered glass are, and which way they are drawn out, at any distance from the impact.
#pragma once

#include <vector>

#include "core/vec.h"
#include "glass/pane.h"

namespace shatterpave::glass {

// The least number of fragments that EN 12150-1 wants in any square of 50 × 50 mm, by the thickness of the glass: 15 at 3 mm,
// 40 from 4 to 12 mm, 30 from 15 mm on, and in a straight line between these.
double least_fragment_count(double thickness_mm);

// The mean number in such a square, away from the impact: what the pane gives, else half as many again as the least number at
// 100 MPa, which goes with the fourth power of the stress; within 1 … 2500.
double fragment_count(const Pane& pane, const Tempered& glass);

// Sizes of fragments, and the map that unfolds them. About the impact fragments are splinters that point away from it; farther
// out they are little longer than wide, along the same way. Unfolded, all are as long as wide, so that splinters are the images
// of common Voronoi cells: the map keeps directions from the impact, and takes the distance r to f(r) with d ln f / d ln r =
// width / length of fragments at r.
class DiceShape {
 public:
  //   reach_mm  the map is made for distances up to here, > 0
  DiceShape(const Pane& pane, const Tempered& glass, vec2 impact_mm, double reach_mm);

  double width_mm(double r_mm) const;   // of a fragment, across the direction from the impact
  double length_mm(double r_mm) const;  // along it
  double far_share(double r_mm) const;  // 0 where there are splinters, 1 where there are none
  // How far apart the cracks between splinters are, side by side.
  double splinter_spacing_mm() const;
  // Width of a fragment at that distance where it is unfolded.
  double unfolded_width(double r_mm) const;
  vec2 unfolded(vec2 p_mm) const;  // about the impact as its origin
  vec2 folded(vec2 q) const;       // the inverse

 private:
  double ratio(double r_mm) const;
  double log_image(double log_r) const;

  vec2 impact_mm_;
  double side_mm_;  // of a square as large as a fragment far out
  double greatest_ratio_;
  double far_ratio_;
  double splinter_reach_mm_;
  std::vector<double> log_images_;  // ln f, at even steps of ln r
};

}  // namespace shatterpave::glass
