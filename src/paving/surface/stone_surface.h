// The upper surface of a stone: cubic Bézier patches over its outline (Miyata and Itoh §4 (1), fig. 3).
//
// A four-cornered stone is the paper's one patch: its 12 outer control points lie on the outline at height 0, the four inner
// ones at the height and at the distance D from the sides that the stone draws. The surface reaches 9/16 of that height.
//
// A stone with other than four corners is split: along the outline a ring of patches, one for each corner and two for each
// side, that rise over the width of a shoulder; within it a crown. All of them lie on one dome and share borders and tangent
// planes, and none has a collapsed edge (POV-Ray shows artefacts on those). A stone with a reflex corner is made as convex
// pieces side by side, as a paver would break it there.
//
// A stone with a finish is made otherwise: paving/surface/stone_body.h; and so is a cell of an organic texture, cell_body.h.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/random.h"
#include "geometry/bezier_patch.h"
#include "paving/pavement.h"
#include "paving/stones.h"
#include "paving/surface/cell_body.h"
#include "paving/surface/stone_body.h"
#include "paving/surface/stone_pieces.h"

namespace shatterpave::paving {

// What a stone draws for itself: a function of the seed, the name of its pavement and its id alone.
struct StoneDraws {
  double height_mm = 0.0;         // of the inner control points
  double sink_mm = 0.0;           // how much lower than its neighbours it lies
  double inset = 0.0;             // D, fraction of the stone, 0 … 0.5
  vec2 slope{0.0, 0.0};           // tilt: rise per mm along x and y
  double colour = 0.0;            // [0, 1), for the choice among the colours of the pavement
  vec2 relief_place{0.0, 0.0};    // of its centre in the periodic relief, each in [0, 1)
  double relief = 1.0;            // factor on the heights of the relief: less where feet have polished it
  std::optional<BodyDraws> body;  // of a stone with a finish: then height, inset and slope above have no effect
  std::optional<CellDraws> cell;  // of a cobble or a scale: the same
};

StoneDraws stone_draws(const Pavement& pavement, std::uint64_t seed, int stone_id);

// What has been worn off a stone where `traffic` (0 at the border, 1 in the middle; paving/surface/wear.h) goes over it: it
// lies lower, its arrises are rounder, its face more even and smoother.
StoneDraws worn(StoneDraws draws, const Pavement& pavement, double traffic);

// The patches over `outline` (simple, counter-clockwise), z up, below the bed along the outline. `is_sawn` says which sides
// were sawn, for stones with a finish. The normals of the patches, derivative_u × derivative_v, point up. Vertices that are no
// corners to `corner_tolerance` of the stone's size are left out; seen from above no point lies outside the outline by more
// than that, but for the tips of scales (`reach_of_cell_mm`).
std::vector<geometry::BezierPatch> surface_patches(const geometry::Polygon& outline, const StoneDraws& draws,
                                                   const IsSawn& is_sawn = {});

// As a fraction of the root of the stone's area: 1.5 mm on a stone of 100 mm, less than what the bed hides of its edge. By eye,
// because a shoulder needs sides that are longer than it is wide.
inline constexpr double corner_tolerance = 0.015;

// Height of the joints' filling above the border of the stones. The bed hides the border, so that no gap shows, but is low
// enough that a joint looks hardly wider than it is: with D = 0.1 a stone of 100 mm loses 0.9 mm on each side.
double bed_level_mm(const StoneSurface& surface);

// The same for any stones, with a finish or without, and the height that no stone exceeds.
double bed_level_mm(const Pavement& pavement);
double top_mm(const Pavement& pavement);
// Of the faces above the outlines of the stones, in the mean.
double face_mm(const Pavement& pavement);

}  // namespace shatterpave::paving
