// Stones with a finish: a face with a crown, arrises of one width, steep sides that end beneath the filling of the joints.
//
// The face is one quadratic polynomial of (x, y): crown, warp and tilt. A rounded arris is a ring of patches, one for each
// corner and one or two for each side, which meet each other and the face with one tangent plane. A chamfered arris is a strip
// along each side, mitred at the corners, above a steep strip, with creases where a mason leaves them. Neighbouring patches
// share whole borders, so that equal steps of subdivision leave no crack.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/random.h"
#include "geometry/bezier_patch.h"
#include "paving/pavement.h"

namespace shatterpave::paving {

// What a stone draws for a chip on one of its sides, each in [0, 1).
struct ChipDraws {
  double chance = 1.0;  // there is a chip if this is below the mean number of chips on the side
  double place = 0.5;
  double size = 0.5;
};

// What a stone with a finish draws for itself.
struct BodyDraws {
  Arris arris = Arris::rounded;
  double arris_mm = 0.0;
  double rise_mm = 0.0;   // of the middles of the face's sides over the outline, where the patches end
  double flank_mm = 0.0;  // the lowest part of that, where the sides of what stands free are steep, below a rounded arris
  double crown_mm = 0.0;
  vec2 warp_mm{0.0, 0.0};     // saddle along the axes of the stone, and along their bisectors
  vec2 slope{0.0, 0.0};       // tilt: rise per mm along x and y
  double tilt_room_mm = 0.0;  // a large stone is tilted less: no corner moves by more than this
  double chips_per_m = 0.0;
  std::array<ChipDraws, 6> chips;  // of the first sides; further ones have none
};

BodyDraws body_draws(const Pavement& pavement, std::uint64_t seed, Id stone);

// Whether the side from `a` to `b` was sawn when the stone was cut to fit: it has a sharp arris without chips.
using IsSawn = std::function<bool(vec2 a, vec2 b)>;

// The patches over `outline`, convex and counter-clockwise, without vertices that are no corners.
std::vector<geometry::BezierPatch> body_patches(geometry::Polygon outline, const BodyDraws& draws, const IsSawn& is_sawn);

// How far the outlines of stones lie below the filling of the joints at the most, so that they never show: by this much a face
// may be warped, tilted and rounded off at its corners, and a millimetre more.
double hidden_depth_mm(const Pavement& pavement);
// The highest that a face may be above the outlines, for stones of up to one and a half times the size.
double highest_face_mm(const Pavement& pavement);

}  // namespace shatterpave::paving
