// Walls of shards that lean, twist and bow: by one field over the pane, so that the walls on both sides of a crack are one
// surface, parted by its gap.
//
// At each height the glass is shifted in the plane, by a smooth noise of the place: what a crack's wall leans by is the part of
// it across the crack. Towards the pane's edge, and towards impacts, where cracks begin, walls stand upright. Tilt, curve and
// length of twist are those of gaps (pane.crack_sheet), whose walls lean by a noise of their own along each crack; shards meet
// at corners, where cracks must agree, so theirs is one for all.
#pragma once

#include <cstdint>
#include <vector>

#include "core/random.h"
#include "core/vec.h"
#include "geometry/polygon.h"
#include "glass/pane.h"

namespace shatterpave::glass {

class Lean {
 public:
  Lean() = default;  // upright
  // Upright unless the pane's shards ask for leaning walls. `part`, 0 … 1, is by how much of what the pane asks for they lean.
  Lean(const Pane& pane, std::uint64_t seed, double part = 1.0);

  bool is_upright() const { return strength_ == 0.0; }
  // How far the glass at a place is shifted aside at a height, z being 0 in the middle plane. Two places stay at least a
  // quarter as far apart as they were, so at no height does a shard enter another one.
  vec2 aside_mm(vec2 at_mm, double z_mm) const;
  // The ring with more vertices on sides that are not old, so that its shifted sides are straight to `bound_mm` at all heights.
  //   is_old  of each side; grows along
  geometry::Polygon followed(const geometry::Polygon& ring, std::vector<bool>& is_old, double bound_mm) const;
  // Over how much of the plane it is nearly even.
  double even_mm() const { return 0.5 * twist_mm_; }

 private:
  vec2 noise(Stream stream, vec2 at_mm) const;
  double upright_share(vec2 at_mm) const;
  bool is_straight(vec2 a, vec2 b, double bound_mm) const;

  double strength_ = 0.0;  // of what is asked for
  double tilt_slope_ = 0.0;
  double curve_slope_ = 0.0;
  double half_mm_ = 1.0;  // of the thickness
  double twist_mm_ = 1.0;
  double reach_mm_ = 1.0;  // from edge and impacts, to where it leans in full
  geometry::Polygon outline_;
  std::vector<vec2> impacts_;
  Id id_;
  std::uint64_t seed_ = 0;
};

}  // namespace shatterpave::glass
