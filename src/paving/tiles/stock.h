// The stock that stones are cut from, and cutting pieces so that each fits it.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "geometry/polygon.h"

namespace shatterpave::paving {

// The largest stone of a bond.
struct Stock {
  vec2 size_mm{0.0, 0.0};  // along the stone's axis, across it
  double area_mm2 = 0.0;   // of its face
  // The size of stones that lie at right angles to `along`, if they have another one; else 0, 0.
  vec2 turned_size_mm{0.0, 0.0};
  vec2 along{1.0, 0.0};

  // Of stones that are larger or smaller by this factor each way.
  Stock times(double factor) const { return {factor * size_mm, factor * factor * area_mm2, factor * turned_size_mm, along}; }

  vec2 size_for(vec2 axis) const {
    const bool turned = turned_size_mm != vec2{0.0, 0.0} && std::abs(glm::dot(axis, along)) < std::abs(cross(axis, along));
    return turned ? turned_size_mm : size_mm;
  }
};

// How far a polygon reaches along an axis (x) and across it (y), mm.
geometry::Box extent(const geometry::Polygon& polygon, vec2 axis);
inline vec2 size_of(const geometry::Box& box) { return box.high - box.low; }

// Four areas over the border: of a square its side, of a long strip twice its width.
double stoutness_mm(const geometry::Polygon& polygon);

// Whether a face with this axis can be cut from the stock, but for rounding.
bool fits(const geometry::Polygon& face, vec2 axis, const Stock& stock);

// A face without what reaches beyond the stock when it lies in its middle: several where it falls apart.
std::vector<geometry::Polygon> trimmed(const geometry::Polygon& face, vec2 axis, const Stock& stock);

// A polygon cut along straight lines across `axis` (`by_length`), or along it, at the given places of its extent, ascending.
// The parts are in order from the lowest; together they are the polygon, but for rounding.
std::vector<geometry::Polygon> cut_across(const geometry::Polygon& polygon, vec2 axis, bool by_length,
                                          const std::vector<double>& places_mm);

// The polygon in two parts of equal area, or as nearly equal as it can be cut so that neither part is longer than `most_mm`
// along the axis (`by_length`) or across it. Nothing if it falls into more parts.
struct Halves {
  geometry::Polygon first;
  geometry::Polygon second;
};
std::optional<Halves> halves(const geometry::Polygon& polygon, vec2 axis, bool by_length, double most_mm);

}  // namespace shatterpave::paving
