// Edges are halved in rounds: first all that are too long are noted, then each triangle is cut by those of its own, one, two or
// three. So no point ever lies within an edge of another triangle.
#include "geometry/bend.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace shatterpave::geometry {

namespace {

// Points of bent plates are multiples of 10 nm: far below what separates two surfaces, and short as text.
constexpr double bent_parts_per_mm = 1e5;
// The middle of a triangle is farther off than those of its edges: the least circle about it is up to 2 / sqrt(3) wider.
constexpr double edge_part = 0.74;

using Corners = std::array<std::uint32_t, 3>;

double on_bent_grid(double mm) { return std::round(mm * bent_parts_per_mm) / bent_parts_per_mm; }

// Not yet of unit length.
vec3 steep(vec2 slope) { return {-slope.x, -slope.y, 1.0}; }

class Halving {
 public:
  Halving(std::span<const vec3> points, const Bend& bend, double bound_mm)
      : points_(points.begin(), points.end()), given_(points.size()), bend_(bend), bound_mm_(edge_part * bound_mm) {}

  // A round; whether there was anything to halve.
  bool halve(Refinement& parts) {
    halves_.clear();
    Refinement next;
    for (std::size_t i = 0; i < parts.triangles.size(); ++i) cut(parts.triangles[i], parts.part_of[i], next);
    parts.triangles = std::move(next.triangles);
    parts.part_of = std::move(next.part_of);
    return !halves_.empty();
  }
  std::vector<Refinement::Mean> added() && { return std::move(added_); }

 private:
  static constexpr std::uint32_t whole = static_cast<std::uint32_t>(-1);

  std::uint32_t half(std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    if (bend_.chord_mm(points_[a], points_[b]) <= bound_mm_) return whole;
    const std::uint64_t edge = (static_cast<std::uint64_t>(a) << 32U) | b;
    const auto [found, is_new] = halves_.try_emplace(edge, static_cast<std::uint32_t>(given_ + added_.size()));
    if (is_new) {
      added_.push_back({a, b});
      points_.push_back(0.5 * (points_[a] + points_[b]));
    }
    return found->second;
  }
  double length(std::uint32_t a, std::uint32_t b) const { return glm::length(points_[a] - points_[b]); }

  void cut(Corners c, std::size_t of, Refinement& next) {
    Corners middles{half(c[0], c[1]), half(c[1], c[2]), half(c[2], c[0])};
    const auto put = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
      next.triangles.push_back({x, y, z});
      next.part_of.push_back(of);
    };
    const auto count = 3 - std::ranges::count(middles, whole);
    // Turned so that the one edge that differs from the others is the first.
    for (int turn = 0; turn < 2 && (count == 1 || count == 2); ++turn) {
      if ((middles[0] == whole) == (count == 2)) break;
      c = {c[1], c[2], c[0]};
      middles = {middles[1], middles[2], middles[0]};
    }
    if (count == 0) {
      put(c[0], c[1], c[2]);
    } else if (count == 1) {
      put(c[0], middles[0], c[2]);
      put(middles[0], c[1], c[2]);
    } else if (count == 2) {
      put(middles[2], middles[1], c[2]);
      const bool first = length(c[0], middles[1]) <= length(c[1], middles[2]);
      put(c[0], c[1], first ? middles[1] : middles[2]);
      if (first) {
        put(c[0], middles[1], middles[2]);
      } else {
        put(c[1], middles[1], middles[2]);
      }
    } else {
      put(c[0], middles[0], middles[2]);
      put(middles[0], c[1], middles[1]);
      put(middles[2], middles[1], c[2]);
      put(middles[0], middles[1], middles[2]);
    }
  }

  std::vector<vec3> points_;
  std::size_t given_;
  const Bend& bend_;
  double bound_mm_;
  std::vector<Refinement::Mean> added_;
  std::unordered_map<std::uint64_t, std::uint32_t> halves_;  // of this round, by edge; looked up only
};

}  // namespace

double Bend::height_mm(vec2 at_mm) const {
  const vec2 part = (at_mm - middle_mm) / half_mm;
  return bow_mm.x * (1.0 - part.x * part.x) + bow_mm.y * (1.0 - part.y * part.y);
}

vec2 Bend::slope(vec2 at_mm) const { return -2.0 * bow_mm * (at_mm - middle_mm) / (half_mm * half_mm); }

double Bend::curvature_per_mm() const {
  const vec2 second = 2.0 * glm::abs(bow_mm) / (half_mm * half_mm);
  return std::max(second.x, second.y);
}

vec3 Bend::point(vec3 flat_mm) const {
  if (is_flat()) return flat_mm;
  const vec2 at{flat_mm.x, flat_mm.y};
  const vec3 bent = vec3{at, height_mm(at)} + flat_mm.z * glm::normalize(steep(slope(at)));
  return {on_bent_grid(bent.x), on_bent_grid(bent.y), on_bent_grid(bent.z)};
}

vec3 Bend::normal(vec3 flat_mm, vec3 normal) const {
  if (is_flat()) return normal;
  const vec2 rise = slope({flat_mm.x, flat_mm.y});
  const vec2 second = -2.0 * bow_mm / (half_mm * half_mm);
  const vec3 up = steep(rise);
  const double steepness = glm::length(up);
  const vec3 out = up / steepness;
  const auto turn = [&](vec3 change) { return (change - glm::dot(change, out) * out) / steepness; };
  const vec3 along_x = vec3{1.0, 0.0, rise.x} + flat_mm.z * turn({-second.x, 0.0, 0.0});
  const vec3 along_y = vec3{0.0, 1.0, rise.y} + flat_mm.z * turn({0.0, -second.y, 0.0});
  return glm::normalize(normal.x * glm::cross(along_y, out) + normal.y * glm::cross(out, along_x) +
                        normal.z * glm::cross(along_x, along_y));
}

double Bend::chord_mm(vec3 a_mm, vec3 b_mm) const {
  const vec2 way = (vec2{a_mm.x, a_mm.y} - vec2{b_mm.x, b_mm.y}) / half_mm;
  return 0.25 * (std::abs(bow_mm.x) * way.x * way.x + std::abs(bow_mm.y) * way.y * way.y);
}

Refinement refinement(std::span<const vec3> points_mm, std::span<const Corners> triangles, const Bend& bend, double bound_mm) {
  Refinement parts;
  parts.triangles.assign(triangles.begin(), triangles.end());
  parts.part_of.resize(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) parts.part_of[i] = i;
  if (bend.is_flat()) return parts;
  Halving halving(points_mm, bend, bound_mm);
  while (halving.halve(parts)) {
  }
  parts.added = std::move(halving).added();
  return parts;
}

}  // namespace shatterpave::geometry
