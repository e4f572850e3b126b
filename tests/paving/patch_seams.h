// Patches that shall meet smoothly, found and measured by brute force; and outlines of stones of all kinds.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/bezier_patch.h"
#include "geometry/polygon.h"

namespace shatterpave::paving {

geometry::Polygon regular(int corners, double radius);

// A convex polygon of `count` corners on an ellipse at uneven angles: all kinds of cut stones.
geometry::Polygon uneven(int count, std::uint64_t number);

// A point of border 0 … 3 (v = 0, u = 1, v = 1, u = 0), and the normal there.
vec3 on_border(const geometry::BezierPatch& patch, int border, double t);
vec3 normal_on_border(const geometry::BezierPatch& patch, int border, double t);

struct Seam {
  std::size_t first = 0;
  int first_border = 0;
  std::size_t second = 0;
  int second_border = 0;
  bool reversed = false;
};

// All pairs of borders with the same ends.
std::vector<Seam> seams(const std::vector<geometry::BezierPatch>& patches);

// The largest distance of points that should be one, and of unit normals, over all seams.
struct SeamErrors {
  double distance_mm = 0.0;
  double normal = 0.0;
};
SeamErrors seam_errors(const std::vector<geometry::BezierPatch>& patches);

void expect_smooth(const std::vector<geometry::BezierPatch>& patches);

}  // namespace shatterpave::paving
