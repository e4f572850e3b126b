#include "paving/tiles/stock.h"

#include <algorithm>
#include <cmath>

#include "geometry/clip.h"
#include "geometry/corners.h"
#include "geometry/lattice.h"

namespace shatterpave::paving {

namespace {

using geometry::Box;
using geometry::Polygon;

// Both corners of a face are rounded to the lattice, twice: when it was cut and when the joint was taken off.
constexpr double stock_rounding_mm = 0.003;

vec2 out_of(vec2 along_across, vec2 axis) { return along_across.x * axis + along_across.y * left_of(axis); }

// The rectangle of an extent, on the lattice.
Polygon rectangle(const Box& box, vec2 axis) {
  Polygon corners = geometry::rectangle(box);
  for (vec2& p : corners) p = geometry::on_lattice(out_of(p, axis));
  return corners;
}

double component(vec2 p, bool by_length) { return by_length ? p.x : p.y; }

// The area of the polygon up to a place along a direction.
double area_below(const Polygon& polygon, vec2 direction, double place) {
  // Sutherland and Hodgman: clipped by one half-plane; what lies on its border has no area.
  double doubled = 0.0;
  vec2 first{0.0, 0.0};
  vec2 last{0.0, 0.0};
  bool any = false;
  const auto add = [&](vec2 p) {
    if (any) {
      doubled += cross(last, p);
    } else {
      first = p;
    }
    any = true;
    last = p;
  };
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    // About the first corner, so that no digits are lost far from the origin.
    const vec2 a = polygon[i] - polygon[0];
    const vec2 b = polygon[(i + 1) % n] - polygon[0];
    const double ha = glm::dot(polygon[i], direction) - place;
    const double hb = glm::dot(polygon[(i + 1) % n], direction) - place;
    if (ha <= 0.0) add(a);
    if ((ha < 0.0 && hb > 0.0) || (ha > 0.0 && hb < 0.0)) add(a + ha / (ha - hb) * (b - a));
  }
  return any ? 0.5 * (doubled + cross(last, first)) : 0.0;
}

}  // namespace

Box extent(const Polygon& polygon, vec2 axis) {
  const vec2 across = left_of(axis);
  Box box;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const vec2 p{glm::dot(polygon[i], axis), glm::dot(polygon[i], across)};
    box = i == 0 ? Box{p, p} : Box{glm::min(box.low, p), glm::max(box.high, p)};
  }
  return box;
}

double stoutness_mm(const Polygon& polygon) {
  double border = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) border += glm::length(polygon[(i + 1) % polygon.size()] - polygon[i]);
  return border > 0.0 ? 4.0 * geometry::area(polygon) / border : 0.0;
}

bool fits(const Polygon& face, vec2 axis, const Stock& stock) {
  const vec2 size = size_of(extent(face, axis));
  const vec2 most = stock.size_for(axis);
  return size.x <= most.x + stock_rounding_mm && size.y <= most.y + stock_rounding_mm &&
         geometry::area(face) <= stock.area_mm2 + stock_rounding_mm * (size.x + size.y);
}

std::vector<Polygon> trimmed(const Polygon& face, vec2 axis, const Stock& stock) {
  const Box box = extent(face, axis);
  const vec2 size = size_of(box);
  const vec2 most = stock.size_for(axis);
  if (size.x <= most.x + stock_rounding_mm && size.y <= most.y + stock_rounding_mm) return {face};
  const vec2 middle = 0.5 * (box.low + box.high);
  const vec2 half = 0.5 * glm::min(size, most);
  std::vector<Polygon> parts;
  for (geometry::Region& part : geometry::intersection(face, {rectangle({middle - half, middle + half}, axis), {}})) {
    if (geometry::is_simple(part.outline)) parts.push_back(std::move(part.outline));
  }
  return parts;
}

std::vector<Polygon> cut_across(const Polygon& polygon, vec2 axis, bool by_length, const std::vector<double>& places_mm) {
  const Box box = extent(polygon, axis);
  const vec2 room{1.0, 1.0};
  std::vector<Polygon> parts;
  Box slab{box.low - room, box.high + room};
  for (std::size_t i = 0; i <= places_mm.size(); ++i) {
    double& high = by_length ? slab.high.x : slab.high.y;
    double& low = by_length ? slab.low.x : slab.low.y;
    high = i < places_mm.size() ? places_mm[i] : component(box.high + room, by_length);
    for (geometry::Region& part : geometry::intersection(polygon, {rectangle(slab, axis), {}})) {
      parts.push_back(std::move(part.outline));
    }
    low = high;
  }
  return parts;
}

std::optional<Halves> halves(const Polygon& polygon, vec2 axis, bool by_length, double most_mm) {
  const Box box = extent(polygon, axis);
  const vec2 direction = by_length ? axis : left_of(axis);
  const double wanted = 0.5 * geometry::area(polygon);
  double low = component(box.low, by_length);
  double high = component(box.high, by_length);
  const double least_place = high - most_mm;
  const double most_place = low + most_mm;
  if (least_place > most_place) return std::nullopt;
  constexpr int steps = 40;
  for (int step = 0; step < steps; ++step) {
    const double half = 0.5 * (low + high);
    (area_below(polygon, direction, half) < wanted ? low : high) = half;
  }
  // In the middle where that is nearly the same: so halves of stones side by side are in line.
  constexpr double nearly = 0.15;
  const double middle = 0.5 * (component(box.low, by_length) + component(box.high, by_length));
  const bool in_line = std::abs(area_below(polygon, direction, middle) - wanted) < nearly * wanted;
  const double place = std::clamp(in_line ? middle : low, least_place, most_place);
  auto parts = cut_across(polygon, axis, by_length, {place});
  if (parts.size() != 2) return std::nullopt;
  return Halves{std::move(parts.front()), std::move(parts.back())};
}

}  // namespace shatterpave::paving
