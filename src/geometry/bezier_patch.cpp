#include "geometry/bezier_patch.h"

#include <limits>

namespace shatterpave::geometry {

namespace {

using Weights = std::array<double, 4>;

Weights bernstein(double t) {
  const double s = 1.0 - t;
  return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}

Weights bernstein_derivative(double t) {
  const double s = 1.0 - t;
  return {-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t};
}

vec3 weighted(const BezierPatch& patch, const Weights& rows, const Weights& columns) {
  vec3 sum{0.0, 0.0, 0.0};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) sum += rows[row] * columns[column] * patch.at(row, column);
  }
  return sum;
}

}  // namespace

vec3 point(const BezierPatch& patch, double u, double v) { return weighted(patch, bernstein(u), bernstein(v)); }

vec3 derivative_u(const BezierPatch& patch, double u, double v) {
  return weighted(patch, bernstein_derivative(u), bernstein(v));
}

vec3 derivative_v(const BezierPatch& patch, double u, double v) {
  return weighted(patch, bernstein(u), bernstein_derivative(v));
}

vec3 unit_normal(const BezierPatch& patch, double u, double v) {
  // Of the angle between the ways: below, rounding and the differences that patches are made by may turn the normal.
  constexpr double least_sine = 1e-4;
  constexpr int steps = 32;
  vec3 best{0.0, 0.0, 0.0};
  double best_sine = 0.0;
  for (int step = 0; step < steps && best_sine < least_sine; ++step) {
    const double inwards = static_cast<double>(step) / steps;
    const double at_u = u + inwards * (0.5 - u);
    const double at_v = v + inwards * (0.5 - v);
    const vec3 by_u = derivative_u(patch, at_u, at_v);
    const vec3 by_v = derivative_v(patch, at_u, at_v);
    const vec3 normal = glm::cross(by_u, by_v);
    const double length = glm::length(normal);
    if (length <= best_sine * glm::length(by_u) * glm::length(by_v)) continue;
    best = normal / length;
    best_sine = length / (glm::length(by_u) * glm::length(by_v));
  }
  return best;
}

double height_at(const std::vector<BezierPatch>& patches, vec2 place) {
  double height = -std::numeric_limits<double>::infinity();
  double nearest2 = std::numeric_limits<double>::infinity();
  constexpr int steps = 8;
  for (const BezierPatch& patch : patches) {
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps; ++j) {
        const vec3 p = point(patch, static_cast<double>(i) / steps, static_cast<double>(j) / steps);
        const vec2 offset = vec2{p.x, p.y} - place;
        const double distance2 = glm::dot(offset, offset);
        if (distance2 >= nearest2) continue;
        nearest2 = distance2;
        height = p.z;
      }
    }
  }
  return height;
}

}  // namespace shatterpave::geometry
