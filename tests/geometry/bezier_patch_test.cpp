#include "geometry/bezier_patch.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace shatterpave::geometry {
namespace {

BezierPatch any_patch(std::uint64_t number) {
  BezierPatch patch;
  for (std::size_t i = 0; i < 16; ++i) {
    const Id id = Id("patch").child(i);
    patch.control_points[i] = {normal(number, {Stream::turn, id, 0}), normal(number, {Stream::turn, id, 1}),
                               normal(number, {Stream::turn, id, 2})};
  }
  return patch;
}

// de Casteljau's construction: repeated linear interpolation.
vec3 de_casteljau(std::array<vec3, 4> points, double t) {
  for (std::size_t count = 3; count > 0; --count) {
    for (std::size_t i = 0; i < count; ++i) points[i] = (1.0 - t) * points[i] + t * points[i + 1];
  }
  return points[0];
}

vec3 oracle(const BezierPatch& patch, double u, double v) {
  std::array<vec3, 4> column{};
  for (std::size_t row = 0; row < 4; ++row) {
    column[row] = de_casteljau({patch.at(row, 0), patch.at(row, 1), patch.at(row, 2), patch.at(row, 3)}, v);
  }
  return de_casteljau(column, u);
}

TEST(BezierPatch, PointIsThatOfDeCasteljau) {
  for (std::uint64_t number = 0; number < 50; ++number) {
    const BezierPatch patch = any_patch(number);
    for (const double u : {0.0, 0.1, 0.5, 0.77, 1.0}) {
      for (const double v : {0.0, 0.3, 0.5, 0.9, 1.0}) {
        EXPECT_LT(glm::length(point(patch, u, v) - oracle(patch, u, v)), 1e-13);
      }
    }
  }
}

TEST(BezierPatch, CornersAreControlPoints) {
  const BezierPatch patch = any_patch(1);
  EXPECT_EQ(point(patch, 0.0, 0.0), patch.control_points[0]);
  EXPECT_EQ(point(patch, 0.0, 1.0), patch.control_points[3]);
  EXPECT_EQ(point(patch, 1.0, 1.0), patch.control_points[15]);
  EXPECT_EQ(point(patch, 1.0, 0.0), patch.control_points[12]);
}

TEST(BezierPatch, DerivativesAreLimitsOfDifferences) {
  const double h = 1e-5;
  const BezierPatch patch = any_patch(2);
  for (const double u : {0.2, 0.5, 0.8}) {
    for (const double v : {0.3, 0.6}) {
      const vec3 along_u = (point(patch, u + h, v) - point(patch, u - h, v)) / (2.0 * h);
      const vec3 along_v = (point(patch, u, v + h) - point(patch, u, v - h)) / (2.0 * h);
      EXPECT_LT(glm::length(derivative_u(patch, u, v) - along_u), 1e-7);
      EXPECT_LT(glm::length(derivative_v(patch, u, v) - along_v), 1e-7);
    }
  }
}

}  // namespace
}  // namespace shatterpave::geometry
