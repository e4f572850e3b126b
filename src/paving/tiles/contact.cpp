#include "paving/tiles/contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/clip.h"

namespace shatterpave::paving {

namespace {

using geometry::Polygon;

struct Span {
  double from = 0.0;
  double to = 0.0;
};

// The part of the segment a that lies together with b, which runs against it: along a, empty if from >= to.
Span together(vec2 a0, vec2 a1, vec2 b0, vec2 b1) {
  const vec2 d = a1 - a0;
  const double along = glm::length(d);
  const vec2 unit = d / along;
  const double s0 = glm::dot(b0 - a0, unit);
  const double s1 = glm::dot(b1 - a0, unit);
  const double low = std::max(0.0, std::min(s0, s1));
  const double high = std::min(along, std::max(s0, s1));
  if (high <= low || s0 == s1) return {};
  const double h0 = cross(unit, b0 - a0);
  const double slope = (cross(unit, b1 - a0) - h0) / (s1 - s0);
  const auto near = [&](double s) { return std::abs(h0 + slope * (s - s0)) <= same_line_mm; };
  return near(low) && near(high) ? Span{low, high} : Span{};
}

// `a` with its corners that lie beside corners of `b` taken to the nearest of them.
Polygon snapped(Polygon a, const Polygon& b) {
  for (vec2& p : a) {
    const auto distance = [&](vec2 q) { return glm::length(q - p); };
    const auto nearest = std::ranges::min_element(b, {}, distance);
    if (nearest != b.end() && distance(*nearest) <= same_line_mm) p = *nearest;
  }
  return a;
}

// `a` with the corners of `b` that lie on its sides as corners of its own.
Polygon refined(const Polygon& a, const Polygon& b) {
  Polygon result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const vec2 d = a[(i + 1) % a.size()] - a[i];
    const double along = glm::length(d);
    result.push_back(a[i]);
    if (along == 0.0) continue;
    std::vector<std::pair<double, vec2>> on_side;
    for (const vec2& q : b) {
      const double t = glm::dot(q - a[i], d) / along;
      const bool on = t > same_line_mm && t < along - same_line_mm && std::abs(cross(d, q - a[i])) <= same_line_mm * along;
      if (on) on_side.emplace_back(t, q);
    }
    std::ranges::sort(on_side, {}, &std::pair<double, vec2>::first);
    for (const auto& corner : on_side) result.push_back(corner.second);
  }
  return result;
}

// The sides of two polygons without those that both have, which run against each other.
std::vector<std::pair<vec2, vec2>> outer_sides(const Polygon& a, const Polygon& b) {
  std::vector<std::pair<vec2, vec2>> sides;
  for (const Polygon* polygon : {&a, &b}) {
    for (std::size_t i = 0; i < polygon->size(); ++i) {
      const std::pair side{(*polygon)[i], (*polygon)[(i + 1) % polygon->size()]};
      const auto opposite = std::ranges::find(sides, std::pair{side.second, side.first});
      if (opposite == sides.end()) {
        sides.push_back(side);
      } else {
        sides.erase(opposite);
      }
    }
  }
  return sides;
}

}  // namespace

std::vector<Contact> contacts(const Polygon& polygon, const Polygon& other) {
  std::vector<Contact> found;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    for (std::size_t j = 0; j < other.size(); ++j) {
      const Span span = together(polygon[i], polygon[(i + 1) % polygon.size()], other[j], other[(j + 1) % other.size()]);
      if (span.from < span.to) found.push_back({i, span.from, span.to});
    }
  }
  return found;
}

double shared_length(const Polygon& a, const Polygon& b) {
  double total = 0.0;
  for (const Contact& contact : contacts(a, b)) total += contact.to_mm - contact.from_mm;
  return total;
}

std::optional<Polygon> joined(const Polygon& a, const Polygon& b) {
  const Polygon moved = snapped(a, b);
  const Polygon other = refined(b, moved);
  auto sides = outer_sides(refined(moved, other), other);
  if (sides.empty()) return std::nullopt;
  Polygon outline;
  vec2 at = sides.front().first;
  while (!sides.empty()) {
    const auto next = std::ranges::find(sides, at, &std::pair<vec2, vec2>::first);
    if (next == sides.end()) return std::nullopt;
    outline.push_back(at);
    at = next->second;
    sides.erase(next);
  }
  outline = geometry::cleaned(outline);
  if (!geometry::is_simple(outline) || geometry::area(outline) <= 0.0) return std::nullopt;
  return outline;
}

}  // namespace shatterpave::paving
