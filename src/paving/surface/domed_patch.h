// Patches that are bilinear in the plane, with heights z = f + G, where G is one quadratic polynomial of (x, y).
//
// Bilinear in (x, y) means that G is of degree (2, 2) in (u, v), so it is represented exactly, and adding it to patches that
// meet smoothly leaves them so.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/bezier_patch.h"
#include "paving/surface/stone_pieces.h"

namespace shatterpave::paving {

// G over `quad` as a polynomial of bidegree (2, 2): control point (i, j) is the mean of G over the ways to choose i of two and
// j of two. `dome.blossom(p, q)` is G in blossomed form: symmetric in p and q, affine in each, and blossom(p, p) is G(p). It
// is called for pairs of corners of `quad`.
template <typename Dome>
double dome_control(const std::array<vec2, 4>& quad, const Dome& dome, std::size_t i, std::size_t j) {
  const auto corner = [&](std::size_t u, std::size_t v) { return quad[v == 0 ? u : 3 - u]; };
  const std::array<std::size_t, 2> us = {i / 2, (i + 1) / 2};
  const std::array<std::size_t, 2> vs = {j / 2, (j + 1) / 2};
  return 0.5 *
         (dome.blossom(corner(us[0], vs[0]), corner(us[1], vs[1])) + dome.blossom(corner(us[0], vs[1]), corner(us[1], vs[0])));
}

// The same raised to degree 3 in both: (q0, (q0 + 2 q1) / 3, (2 q1 + q2) / 3, q2).
template <typename Dome>
double raised_dome_control(const std::array<vec2, 4>& quad, const Dome& dome, std::size_t row, std::size_t column) {
  constexpr std::array<std::array<double, 3>, 4> raise = {
      {{1.0, 0.0, 0.0}, {1.0 / 3.0, 2.0 / 3.0, 0.0}, {0.0, 2.0 / 3.0, 1.0 / 3.0}, {0.0, 0.0, 1.0}}};
  double height = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) height += raise[row][i] * raise[column][j] * dome_control(quad, dome, i, j);
  }
  return height;
}

// A patch over `quad`, convex and counter-clockwise, with `shoulder(row, column)` as control heights of f.
template <typename Dome, typename Shoulder>
geometry::BezierPatch domed_patch(const std::array<vec2, 4>& quad, const Dome& dome, const Shoulder& shoulder) {
  geometry::BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const vec2 place = bilinear(quad, static_cast<double>(row) / 3.0, static_cast<double>(column) / 3.0);
      patch.at(row, column) = {place.x, place.y, shoulder(row, column) + raised_dome_control(quad, dome, row, column)};
    }
  }
  return patch;
}

}  // namespace shatterpave::paving
