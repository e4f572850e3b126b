// Plates that are bent: one map from the flat plate to the bent one, and triangles small enough to follow it.
//
// The middle plane goes to a paraboloid over the plate's box: z = bow.x (1 - u²) + bow.y (1 - v²), where u and v run from -1 to
// 1 over the box. What is off the middle plane stays as far off, along the normal of the paraboloid. So corners of the box stay
// where they are, the middle rises by bow.x + bow.y, and seen from the front the middle plane is as it was drawn. A parabola
// differs from the circle of the same sagitta by less than 4 % of it where the sagitta is a tenth of the span. Only + - * / and
// square roots are used, so that the bits are the same on any processor.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace shatterpave::geometry {

struct Bend {
  vec2 middle_mm{0.0, 0.0};  // of the box
  vec2 half_mm{1.0, 1.0};    // half its sides, > 0
  vec2 bow_mm{0.0, 0.0};     // sagitta across the box and along it; above 0 the middle comes towards +z

  bool is_flat() const { return bow_mm.x == 0.0 && bow_mm.y == 0.0; }
  // Of the middle plane, and how it rises.
  double height_mm(vec2 at_mm) const;
  vec2 slope(vec2 at_mm) const;
  // The greatest curvature, 1/mm. What is thicker than twice its reciprocal would fold.
  double curvature_per_mm() const;
  // Where a point of the flat plate goes; multiples of 10 nm. A flat bend leaves it as it is.
  vec3 point(vec3 flat_mm) const;
  // Where a unit normal of the flat plate at that point goes: that of the bent surface, of unit length.
  vec3 normal(vec3 flat_mm, vec3 normal) const;
  // How far the middle of a straight edge lies off the bent one, at the most.
  double chord_mm(vec3 a_mm, vec3 b_mm) const;
};

// Triangles cut until they follow the bend.
struct Refinement {
  // Points that are added, numbered on from the given ones: each is the mean of two earlier ones.
  struct Mean {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
  };
  std::vector<Mean> added;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // turned as those they are parts of
  std::vector<std::size_t> part_of;                     // of each the number of the triangle that it is a part of
};

// Halves edges until none of the triangles, once it is bent, is off the bent surface by more than `bound_mm`. Whether an edge
// is halved depends on where its ends are alone, so that surfaces which share an edge, also as points of their own, still do.
//   points_mm  before they are bent
//   bound_mm > 0
Refinement refinement(std::span<const vec3> points_mm, std::span<const std::array<std::uint32_t, 3>> triangles,
                      const Bend& bend, double bound_mm);

}  // namespace shatterpave::geometry
