// The split surface, side by side with the paper's single patch:
//
//   All patches are bilinear in the plane, and their heights are z = f + G, where G, the dome, is one quadratic polynomial of
//   (x, y) for the whole piece (domed_patch.h). It remains to choose f, the shoulder: with heights 0, h, h, h of the control
//   points from the outline inwards it is h (1 − (1 − t)³), steep at the outline and level at the crown.
//   - A corner patch is a parallelogram of corner, two points on the sides and a corner of the crown; f is the product of the
//     shoulders of both its sides.
//   - Two side patches lie between the corner patches of a side's ends. At the borders along the ring all derivatives across
//     have f constant and are parallel to the side, so the tangent planes agree.
//   - The crown is level in f, and is split by its centre and the middles of its sides into one four-sided patch a corner.
#include "paving/surface/stone_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/functions.h"
#include "paving/surface/domed_patch.h"
#include "paving/surface/stone_pieces.h"

namespace shatterpave::paving {

using geometry::BezierPatch;
using geometry::Polygon;

namespace {

// ---- one patch over four corners

// The paper's patch. `quad` is convex and counter-clockwise.
BezierPatch single_patch(const std::array<vec2, 4>& quad, const StoneDraws& draws) {
  const vec2 centre = 0.25 * (quad[0] + quad[1] + quad[2] + quad[3]);
  // The control points along the sides stand at D as well, so that the places of the rows do not depend on the column.
  const std::array<double, 4> inner = {0.0, draws.inset, 1.0 - draws.inset, 1.0};
  BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const vec2 place = bilinear(quad, inner[row], inner[column]);
      const bool raised = (row == 1 || row == 2) && (column == 1 || column == 2);
      const double height = raised ? std::max(0.0, draws.height_mm + glm::dot(draws.slope, place - centre)) : 0.0;
      patch.at(row, column) = {place.x, place.y, height};
    }
  }
  return patch;
}

// ---- the split surface over a convex polygon of any number of corners

// The height of the top of the single patch, over that of its inner control points: (3 · ½ · ½)².
constexpr double top_of_single_patch = 9.0 / 16.0;

// How far the dome falls from its centre to half the size of the stone, as a fraction of its height: as the single patch does
// from its centre to its shoulder. By eye, so that cut stones do not look flatter than whole ones.
constexpr double dome_fall = 0.25;

// The shoulder is as steep at the outline as that of the single patch, 2.25 h / (D · size), if it is this many D · size wide.
constexpr double shoulder_of_inset = 3.0 * top_of_single_patch / 2.25;
constexpr double narrowest_shoulder = 0.06;  // fractions of the size; by eye: narrower ones look like cut edges,
constexpr double widest_shoulder = 0.25;     // wider ones meet in the middle
constexpr double least_shoulder = 0.03;      // below that, corners are left out until the shoulder is wider
constexpr double used_of_crown = 0.8;        // of the width at which the crown would lose a side

struct Dome {
  vec2 centre{0.0, 0.0};
  double curvature = 0.0;  // G = −curvature · distance²

  // G in blossomed form: the value that two points contribute to, symmetric and linear in each; blossom(p, p) = G(p).
  double blossom(vec2 p, vec2 q) const { return -curvature * glm::dot(p - centre, q - centre); }
};

// The width of the shoulder at which a side is used up: by the parallelograms at its ends, or within the crown.
double feasible_shoulder(const Polygon& polygon) {
  double width = std::numeric_limits<double>::infinity();
  const auto on_outline = [&](std::size_t i) { return 1.0 / corner_sine(polygon, i); };
  // Of the inner angle θ, cot(θ/2) = (1 + cos θ) / sin θ; the turn is π − θ.
  const auto on_crown = [&](std::size_t i) { return (1.0 - corner_cosine(polygon, i)) / corner_sine(polygon, i); };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    const double length = glm::length(polygon[next] - polygon[i]);
    width = std::min({width, length / (on_outline(i) + on_outline(next)), length / (on_crown(i) + on_crown(next))});
  }
  return used_of_crown * width;
}

// The ring of corner and side patches, and the crown, as the head of this file tells.
std::vector<BezierPatch> split_patches(const Polygon& polygon, double width, const StoneDraws& draws) {
  const std::size_t count = polygon.size();
  const double size = std::sqrt(geometry::area(polygon));
  const double rise = top_of_single_patch * draws.height_mm;
  const Dome dome{geometry::centroid(polygon), dome_fall * rise / (0.25 * size * size)};
  const auto along = [&](std::size_t i) { return glm::normalize(cyclic(polygon, i + 1) - cyclic(polygon, i)); };
  const auto reach = [&](std::size_t i) { return width / corner_sine(polygon, i % count); };
  Polygon crown(count);
  for (std::size_t i = 0; i < count; ++i) crown[i] = polygon[i] + reach(i) * (along(i) - along(i + count - 1));
  const vec2 middle = geometry::centroid(crown);

  std::vector<BezierPatch> patches;
  patches.reserve(4 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const vec2 leaving = polygon[i] + reach(i) * along(i);
    const vec2 arriving = polygon[i] - reach(i) * along(i + count - 1);
    const vec2 far = polygon[next] - reach(next) * along(i);
    patches.push_back(domed_patch({polygon[i], leaving, crown[i], arriving}, dome, [rise](std::size_t row, std::size_t column) {
      return row == 0 || column == 0 ? 0.0 : rise;
    }));
    const vec2 side_middle = 0.5 * (crown[i] + crown[next]);
    const vec2 outline_middle = 0.5 * (leaving + far);
    for (const std::array<vec2, 4>& quad : {std::array{leaving, outline_middle, side_middle, crown[i]},
                                            std::array{outline_middle, far, crown[next], side_middle}}) {
      patches.push_back(domed_patch(quad, dome, [rise](std::size_t, std::size_t column) { return column == 0 ? 0.0 : rise; }));
    }
    const vec2 side_before = 0.5 * (crown[i] + before(crown, i));
    patches.push_back(
        domed_patch({crown[i], side_middle, middle, side_before}, dome, [rise](std::size_t, std::size_t) { return rise; }));
  }
  return patches;
}

std::vector<BezierPatch> convex_patches(Polygon polygon, const StoneDraws& draws) {
  const double size = std::sqrt(geometry::area(polygon));
  while (polygon.size() > 4 && feasible_shoulder(polygon) < least_shoulder * size) leave_out_least_corner(polygon);
  if (polygon.size() == 4) return {single_patch({polygon[0], polygon[1], polygon[2], polygon[3]}, draws)};
  const double wanted = std::clamp(shoulder_of_inset * draws.inset, narrowest_shoulder, widest_shoulder) * size;
  return split_patches(polygon, std::min(wanted, feasible_shoulder(polygon)), draws);
}

// Largest tilt of a stone, as a rise per mm: 1°. By eye, because less does not show and more looks like a neglected path.
constexpr double usual_slope = 0.0175;

double largest_slope(const Variation& variation) {
  if (!variation.tilt) return usual_slope;
  return sine(variation.tilt->radians()) / cosine(variation.tilt->radians());
}

std::vector<BezierPatch> patches_of_piece(const Polygon& piece, const StoneDraws& draws, const IsSawn& is_sawn) {
  if (draws.cell) return cell_patches(piece, *draws.cell);
  return draws.body ? body_patches(piece, *draws.body, is_sawn) : convex_patches(piece, draws);
}

}  // namespace

StoneDraws stone_draws(const Pavement& pavement, std::uint64_t seed, int stone_id) {
  const Id id = Id(pavement.name).child(static_cast<std::uint64_t>(stone_id));
  const auto draw = [&](Stream stream, std::uint32_t index) { return uniform(seed, {stream, id, index}); };
  const auto around_zero = [&](Stream stream, std::uint32_t index) { return 2.0 * draw(stream, index) - 1.0; };
  const StoneSurface& surface = pavement.surface;
  StoneDraws draws;
  draws.height_mm = surface.height_mm * (1.0 + surface.height_spread * around_zero(Stream::stone_height, 0));
  draws.inset = std::clamp(surface.inset * (1.0 + surface.inset_spread * around_zero(Stream::stone_inset, 0)), 0.0, 0.5);
  draws.slope =
      largest_slope(pavement.variation) * vec2{around_zero(Stream::stone_tilt, 0), around_zero(Stream::stone_tilt, 1)};
  draws.sink_mm = pavement.variation.sink_mm * draw(Stream::stone_sink, 0);
  draws.colour = draw(Stream::stone_colour, 0);
  draws.relief_place = {draw(Stream::stone_relief, 0), draw(Stream::stone_relief, 1)};
  if (is_of_cells(pavement)) {
    draws.cell = cell_draws(pavement, seed, id);
  } else if (pavement.body.finish != Finish::none) {
    draws.body = body_draws(pavement, seed, id);
  }
  return draws;
}

StoneDraws worn(StoneDraws draws, const Pavement& pavement, double traffic) {
  if (!draws.body || pavement.body.wear_mm == 0.0) return draws;
  // By eye: a stone in the middle of an old path has half the roughness, and arrises as round again.
  draws.sink_mm += traffic * pavement.body.wear_mm;
  draws.relief *= 1.0 - 0.5 * traffic;
  draws.body->arris_mm *= 1.0 + traffic;
  draws.body->warp_mm *= 1.0 - 0.5 * traffic;
  draws.body->chips_per_m *= 1.0 - 0.5 * traffic;
  return draws;
}

std::vector<BezierPatch> surface_patches(const Polygon& outline, const StoneDraws& draws, const IsSawn& is_sawn) {
  ENSURE(outline.size() >= 3);
  const double tolerance_mm = corner_tolerance * std::sqrt(std::abs(geometry::area(outline)));
  std::vector<BezierPatch> patches;
  for (const Polygon& piece : convex_pieces(outline, tolerance_mm)) {
    if (geometry::area(piece) <= 0.0) continue;
    const std::vector<BezierPatch> part = patches_of_piece(piece, draws, is_sawn);
    patches.insert(patches.end(), part.begin(), part.end());
  }
  for (BezierPatch& patch : patches) {
    for (vec3& point : patch.control_points) point.z -= draws.sink_mm;
  }
  return patches;
}

double bed_level_mm(const StoneSurface& surface) { return 0.05 * surface.height_mm; }

double bed_level_mm(const Pavement& pavement) {
  if (is_of_cells(pavement)) return cell_bed_mm(pavement);
  return pavement.body.finish == Finish::none ? bed_level_mm(pavement.surface) : hidden_depth_mm(pavement);
}

double top_mm(const Pavement& pavement) {
  if (is_of_cells(pavement)) return cell_top_mm(pavement);
  if (pavement.body.finish != Finish::none) return highest_face_mm(pavement);
  return top_of_single_patch * pavement.surface.height_mm * (1.0 + pavement.surface.height_spread);
}

double face_mm(const Pavement& pavement) {
  if (is_of_cells(pavement)) return cell_bed_mm(pavement) + pavement.surface.height_mm;
  return pavement.body.finish == Finish::none ? top_of_single_patch * pavement.surface.height_mm
                                              : bed_level_mm(pavement) + pavement.surface.height_mm;
}

}  // namespace shatterpave::paving
