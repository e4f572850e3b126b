#include "paving/bonds/module_corners.h"

#include <algorithm>
#include <cmath>

#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "paving/bonds/module_cells.h"

namespace shatterpave::paving {

namespace {

using geometry::Box;
using geometry::Polygon;

// Corners that lie nearer to the line between their neighbours are none: two of them are rounded to the lattice.
constexpr double least_bend_mm = 0.0015;

// A corner of a shape: a point that it shares with others, and by which vector that is repeated.
struct Corner {
  std::size_t point = 0;
  vec2 shift{0.0, 0.0};
};

double distance_mm(vec2 p, vec2 a, vec2 b, vec2* foot = nullptr) {
  const vec2 d = b - a;
  const double at = std::clamp(glm::dot(p - a, d) / glm::dot(d, d), 0.0, 1.0);
  const vec2 nearest = a + at * d;
  if (foot != nullptr) *foot = nearest;
  return glm::length(p - nearest);
}

// The corners of all shapes, in which those that are meant to be one are one.
class Corners {
 public:
  Corners(const std::vector<Polygon>& shapes, const Repeats& repeats) : repeats_(repeats) {
    shapes_.reserve(shapes.size());
    for (const Polygon& shape : shapes) {
      std::vector<Corner>& corners = shapes_.emplace_back();
      corners.reserve(shape.size());
      for (const vec2& p : shape) corners.push_back(corner_at(p));
    }
    for (std::size_t i = 0; i < points_.size(); ++i) move_to_side(i);
  }

  std::vector<Polygon> shapes() const {
    std::vector<Polygon> result;
    result.reserve(shapes_.size());
    for (const std::vector<Corner>& corners : shapes_) {
      Polygon& shape = result.emplace_back();
      for (const Corner& corner : corners) shape.push_back(points_[corner.point] + corner.shift);
    }
    return result;
  }

 private:
  Corner corner_at(vec2 p) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const vec2 shift = repeats_.nearest(p - points_[i]);
      if (glm::length(p - points_[i] - shift) <= module_tolerance_mm) return {i, shift};
    }
    points_.push_back(p);
    return {points_.size() - 1, {0.0, 0.0}};
  }

  // Onto the first side that passes by it, if there is one.
  void move_to_side(std::size_t point) {
    for (const std::vector<Corner>& corners : shapes_) {
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Corner& from = corners[i];
        const Corner& to = corners[(i + 1) % corners.size()];
        if (from.point == point || to.point == point) continue;
        if (move_onto(point, points_[from.point] + from.shift, points_[to.point] + to.shift)) return;
      }
    }
  }

  bool move_onto(std::size_t point, vec2 a, vec2 b) {
    if (a == b) return false;
    const vec2 room = repeats_.extent_of(module_tolerance_mm);
    const Box side{glm::min(repeats_.parts_of(a), repeats_.parts_of(b)) - room,
                   glm::max(repeats_.parts_of(a), repeats_.parts_of(b)) + room};
    const vec2 at = repeats_.parts_of(points_[point]);
    bool found = false;
    for_repeats(side, {at, at}, [&](vec2 times) {
      const vec2 shift = repeats_.at(times);
      vec2 foot;
      if (found || distance_mm(points_[point] + shift, a, b, &foot) > module_tolerance_mm) return;
      // Beside an end it is a corner of its own.
      if (std::min(glm::length(foot - a), glm::length(foot - b)) <= module_tolerance_mm) return;
      points_[point] = foot - shift;
      found = true;
    });
    return found;
  }

  const Repeats& repeats_;
  std::vector<vec2> points_;
  std::vector<std::vector<Corner>> shapes_;
};

// Without corners that are none, still unrounded; empty where nothing is left.
Polygon without_straight_corners(const Polygon& polygon) {
  Polygon kept = polygon;
  for (std::size_t i = 0; i < kept.size() && kept.size() >= 3;) {
    const vec2 before = kept[(i + kept.size() - 1) % kept.size()];
    const vec2 after = kept[(i + 1) % kept.size()];
    if (before == after || distance_mm(kept[i], before, after) <= least_bend_mm) {
      kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
      i = i > 0 ? i - 1 : 0;
    } else {
      ++i;
    }
  }
  return kept.size() < 3 ? Polygon() : kept;
}

}  // namespace

bool is_sound(const Polygon& polygon) {
  if (polygon.size() < 3) return false;
  const Polygon rounded = moved(polygon, {0.0, 0.0});
  return std::ranges::adjacent_find(rounded) == rounded.end() && rounded.front() != rounded.back() &&
         geometry::is_simple(rounded) && geometry::area(rounded) > 0.0;
}

std::vector<Polygon> welded(const std::vector<Polygon>& shapes, const Repeats& repeats) {
  std::vector<Polygon> result = Corners(shapes, repeats).shapes();
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = without_straight_corners(result[i]);
    if (!is_sound(result[i])) result[i] = shapes[i];
  }
  return result;
}

}  // namespace shatterpave::paving
