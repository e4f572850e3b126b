// The pieces of a body as one mesh whose facets share their points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "export/shapes/body.h"

namespace shatterpave::exporting::usd {

// What each corner of a facet has, such as its normal: distinct values, in whole parts, and how corners come by theirs.
template <std::size_t width>
struct CornerValues {
  using Value = std::array<std::int64_t, width>;
  std::vector<Value> values;
  // Of the corners of all facets, in order; empty where each point has one value, whatever the facet: then values are those of
  // the points.
  std::vector<std::uint32_t> of_corner;
};

struct WeldedMesh {
  std::vector<std::array<std::int64_t, 3>> points;  // parts_of_m
  std::vector<std::uint32_t> corners;               // points of the facets, three each, counter-clockwise from outside
  CornerValues<3> normals;                          // parts_of_one
  CornerValues<2> places;                           // parts_of_uv
  std::vector<std::size_t> facets_of_piece;         // how many of the facets, in order, are of each piece
};

// Guarantees:
// 1. No two points are at one place, in the parts in which they are written, so that what is closed stays closed.
// 2. No facet has two corners at one place: those that rounding would bring together are left out.
WeldedMesh welded(const std::vector<shapes::Piece>& pieces);

}  // namespace shatterpave::exporting::usd
