#include "paving/patch_seams.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/angle.h"
#include "core/random.h"

namespace shatterpave::paving {

using geometry::BezierPatch;
using geometry::Polygon;

Polygon regular(int corners, double radius) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const Angle angle = Angle::degrees(360.0 * i / corners + 11.0);
    polygon.push_back(radius * angle.direction());
  }
  return polygon;
}

Polygon uneven(int count, std::uint64_t number) {
  Polygon polygon;
  double turn = 0.0;
  std::vector<double> steps;
  for (int i = 0; i < count; ++i) {
    steps.push_back(0.4 + uniform(number, {Stream::turn, Id("step"), static_cast<std::uint32_t>(i)}));
    turn += steps.back();
  }
  double angle = 0.0;
  for (const double step : steps) {
    angle += step / turn * 2.0 * pi;
    polygon.push_back({300.0 + 55.0 * cosine(angle), -200.0 + 40.0 * sine(angle)});
  }
  return polygon;
}

vec3 on_border(const BezierPatch& patch, int border, double t) {
  switch (border) {
    case 0:
      return point(patch, t, 0.0);
    case 1:
      return point(patch, 1.0, t);
    case 2:
      return point(patch, t, 1.0);
    default:
      return point(patch, 0.0, t);
  }
}

vec3 normal_on_border(const BezierPatch& patch, int border, double t) {
  switch (border) {
    case 0:
      return unit_normal(patch, t, 0.0);
    case 1:
      return unit_normal(patch, 1.0, t);
    case 2:
      return unit_normal(patch, t, 1.0);
    default:
      return unit_normal(patch, 0.0, t);
  }
}

std::vector<Seam> seams(const std::vector<BezierPatch>& patches) {
  const auto same = [](vec3 a, vec3 b) { return glm::length(a - b) < 1e-9; };
  std::vector<Seam> found;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    for (std::size_t j = i + 1; j < patches.size(); ++j) {
      for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) {
          const vec3 a0 = on_border(patches[i], a, 0.0);
          const vec3 a1 = on_border(patches[i], a, 1.0);
          const vec3 b0 = on_border(patches[j], b, 0.0);
          const vec3 b1 = on_border(patches[j], b, 1.0);
          if (same(a0, b0) && same(a1, b1)) found.push_back({i, a, j, b, false});
          if (same(a0, b1) && same(a1, b0)) found.push_back({i, a, j, b, true});
        }
      }
    }
  }
  return found;
}

SeamErrors seam_errors(const std::vector<BezierPatch>& patches) {
  SeamErrors worst;
  for (const Seam& seam : seams(patches)) {
    for (double t = 0.0; t <= 1.0; t += 0.125) {
      const double s = seam.reversed ? 1.0 - t : t;
      const BezierPatch& first = patches[seam.first];
      const BezierPatch& second = patches[seam.second];
      const vec3 apart = on_border(first, seam.first_border, t) - on_border(second, seam.second_border, s);
      const vec3 turned = normal_on_border(first, seam.first_border, t) - normal_on_border(second, seam.second_border, s);
      worst.distance_mm = std::max(worst.distance_mm, glm::length(apart));
      worst.normal = std::max(worst.normal, glm::length(turned));
    }
  }
  return worst;
}

void expect_smooth(const std::vector<BezierPatch>& patches) {
  const SeamErrors errors = seam_errors(patches);
  EXPECT_LT(errors.distance_mm, 1e-9);
  EXPECT_LT(errors.normal, 1e-9);
}

}  // namespace shatterpave::paving
