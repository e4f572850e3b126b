#include "paving/surface/stone_pieces.h"

#include <cmath>
#include <limits>
#include <optional>

#include "core/error.h"

namespace shatterpave::paving {

using geometry::Polygon;

namespace {

// Distance of vertex i from the line through its neighbours; positive where the corner is convex.
double prominence(const Polygon& polygon, std::size_t i) {
  const vec2 chord = cyclic(polygon, i + 1) - before(polygon, i);
  const double length = glm::length(chord);
  if (length == 0.0) return 0.0;
  return cross(polygon[i] - before(polygon, i), chord) / length;
}

std::size_t least_corner(const Polygon& polygon) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    if (std::abs(prominence(polygon, i)) < std::abs(prominence(polygon, least))) least = i;
  }
  return least;
}

void remove_vertex(Polygon& polygon, std::size_t i) { polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i)); }

struct Chord {
  std::size_t side = 0;  // from vertex `side` to the next
  vec2 end{0.0, 0.0};
  double length = std::numeric_limits<double>::infinity();
};

// Where the ray from the reflex corner `from` along `direction` first meets a side that does not end in that corner.
Chord first_hit(const Polygon& polygon, std::size_t from, vec2 direction) {
  Chord best;
  const std::size_t count = polygon.size();
  for (std::size_t side = 0; side < count; ++side) {
    if (side == from || (side + 1) % count == from) continue;
    const vec2 along = cyclic(polygon, side + 1) - polygon[side];
    const vec2 offset = polygon[side] - polygon[from];
    const double sine_of_angle = cross(direction, along);
    if (sine_of_angle == 0.0) continue;
    const double distance = cross(offset, along) / sine_of_angle;
    const double place = cross(offset, direction) / sine_of_angle;
    if (distance <= 0.0 || place < 0.0 || place > 1.0 || distance >= best.length) continue;
    best = {side, polygon[side] + place * along, distance};
  }
  return best;
}

// The vertices from `first` to `last`, in cyclic order.
Polygon chain(const Polygon& polygon, std::size_t first, std::size_t last) {
  Polygon part;
  for (std::size_t i = first;; ++i) {
    part.push_back(cyclic(polygon, i));
    if (i % polygon.size() == last % polygon.size()) return part;
  }
}

}  // namespace

Polygon corners(const Polygon& outline, double tolerance_mm) {
  Polygon kept = outline;
  while (kept.size() > 3) {
    const std::size_t least = least_corner(kept);
    if (std::abs(prominence(kept, least)) > tolerance_mm) break;
    remove_vertex(kept, least);
  }
  return kept;
}

std::vector<Polygon> convex_pieces(const Polygon& polygon, double tolerance_mm) {
  std::vector<Polygon> pieces;
  std::vector<Polygon> waiting = {polygon};
  while (!waiting.empty()) {
    const Polygon piece = corners(waiting.back(), tolerance_mm);
    waiting.pop_back();
    std::optional<std::size_t> reflex;
    for (std::size_t i = 0; i < piece.size() && !reflex; ++i) {
      if (prominence(piece, i) < 0.0) reflex = i;
    }
    if (!reflex || piece.size() <= 3) {
      pieces.push_back(piece);
      continue;
    }
    const std::size_t at = *reflex;
    const Chord onward = first_hit(piece, at, glm::normalize(piece[at] - before(piece, at)));
    const Chord backward = first_hit(piece, at, glm::normalize(piece[at] - cyclic(piece, at + 1)));
    const Chord& cut = onward.length <= backward.length ? onward : backward;
    ENSURE(cut.length < std::numeric_limits<double>::infinity());
    Polygon left = chain(piece, at, cut.side);
    left.push_back(cut.end);
    Polygon right = chain(piece, cut.side + 1, at);
    right.push_back(cut.end);
    waiting.push_back(left);
    waiting.push_back(right);
  }
  return pieces;
}

void leave_out_least_corner(Polygon& polygon) { remove_vertex(polygon, least_corner(polygon)); }

double corner_sine(const Polygon& polygon, std::size_t i) {
  return cross(glm::normalize(polygon[i] - before(polygon, i)), glm::normalize(cyclic(polygon, i + 1) - polygon[i]));
}

double corner_cosine(const Polygon& polygon, std::size_t i) {
  return glm::dot(glm::normalize(polygon[i] - before(polygon, i)), glm::normalize(cyclic(polygon, i + 1) - polygon[i]));
}

vec2 bilinear(const std::array<vec2, 4>& quad, double u, double v) {
  return (1.0 - u) * ((1.0 - v) * quad[0] + v * quad[3]) + u * ((1.0 - v) * quad[1] + v * quad[2]);
}

}  // namespace shatterpave::paving
