// Vectors, and the one place that configures GLM.
//
// Lengths are millimetres in double; the plane is right-handed with x to the right, y up, and z out of the plane towards
// the viewer. SIMD is left off: it would change the last bit between builds.
#pragma once

#define GLM_FORCE_PURE
#define GLM_FORCE_XYZW_ONLY
#define GLM_FORCE_SIZE_T_LENGTH
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace shatterpave {

using vec2 = glm::dvec2;
using vec3 = glm::dvec3;

// z of the cross product: twice the signed area of the triangle (0, a, b), positive where b lies left of a.
constexpr double cross(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// `v` turned by a quarter turn to the left.
constexpr vec2 left_of(vec2 v) { return {-v.y, v.x}; }

}  // namespace shatterpave
