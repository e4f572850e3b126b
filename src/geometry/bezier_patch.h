// Cubic Bézier patches in space.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/vec.h"

namespace shatterpave::geometry {

// Tensor-product patch of 16 control points, row by row: the point 4 * row + column belongs to B_row(u) B_column(v), where B
// are the cubic Bernstein polynomials. Its corners are the control points 0 (u = v = 0), 3 (v = 1), 15 and 12 (u = 1).
struct BezierPatch {
  std::array<vec3, 16> control_points{};

  vec3& at(std::size_t row, std::size_t column) { return control_points[4 * row + column]; }
  const vec3& at(std::size_t row, std::size_t column) const { return control_points[4 * row + column]; }

  bool operator==(const BezierPatch&) const = default;
};

// u and v in [0, 1].
vec3 point(const BezierPatch& patch, double u, double v);
vec3 derivative_u(const BezierPatch& patch, double u, double v);
vec3 derivative_v(const BezierPatch& patch, double u, double v);

// derivative_u × derivative_v, of unit length. Where both run alike, as in the corner of a patch on a smooth rim, or one is 0,
// that of the nearest place towards the middle where they do not; 0 of a patch without area.
vec3 unit_normal(const BezierPatch& patch, double u, double v);

// The height z of the patches at `place`: that of the nearest of 9 × 9 points of each patch; −∞ without patches.
double height_at(const std::vector<BezierPatch>& patches, vec2 place);

}  // namespace shatterpave::geometry
