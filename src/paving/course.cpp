#include "paving/course.h"

#include <algorithm>
#include <cmath>

#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "paving/near_index.h"

namespace shatterpave::paving {

namespace {

using geometry::Polygon;

// A corner is sharp where the line turns by more than this; the joint there is a mitre. Cosine of 25°: by eye, less is a bend.
constexpr double sharp_cosine = 0.906;
// A bend that turns by more than 3° keeps perpends off its mitre.
constexpr double bend_cosine = 0.9986;
// Mitres are no longer than this, in half depths: sharper corners are no corners of stones.
constexpr double longest_mitre = 4.0;

// A closed line, measured by length from its first point.
class Line {
 public:
  explicit Line(const Polygon& points) : points_(points) {
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const vec2 d = points[(i + 1) % n] - points[i];
      at_.push_back(total_);
      total_ += glm::length(d);
      normals_.push_back(left_of(d / glm::length(d)));
    }
    at_.push_back(total_);
  }

  std::size_t count() const { return points_.size(); }
  double total() const { return total_; }
  double at(std::size_t vertex) const {
    const std::size_t rounds = vertex / count();
    return at_[vertex % count()] + static_cast<double>(rounds) * total_;
  }
  // Cosine of the turn at a vertex.
  double turn_cosine(std::size_t vertex) const { return glm::dot(normal_before(vertex), normals_[vertex % count()]); }

  // The place, and how far from it the same place of a line one to the left lies.
  struct Cross {
    vec2 place{0.0, 0.0};
    vec2 mitre{0.0, 0.0};
  };
  Cross at_vertex(std::size_t vertex) const {
    const vec2 a = normal_before(vertex);
    const vec2 b = normals_[vertex % count()];
    const double scale = 1.0 / std::max(1.0 + glm::dot(a, b), 2.0 / (longest_mitre * longest_mitre));
    return {points_[vertex % count()], scale * (a + b)};
  }
  // `s` from 0 to twice the length.
  Cross at_length(double s) const {
    const std::size_t round = s >= total_ ? 1 : 0;
    const double rest = s - static_cast<double>(round) * total_;
    const auto after = std::upper_bound(at_.begin(), at_.end() - 1, rest);
    const auto edge = static_cast<std::size_t>(after - at_.begin()) - 1;
    if (rest - at_[edge] < same_place_mm) return at_vertex(edge);
    if (at_[edge + 1] - rest < same_place_mm) return at_vertex(edge + 1);
    const double t = (rest - at_[edge]) / (at_[edge + 1] - at_[edge]);
    return {points_[edge] + t * (points_[(edge + 1) % count()] - points_[edge]), normals_[edge]};
  }
  // The vertices strictly between two lengths, as numbers that go on after the last one.
  std::vector<std::size_t> between(double from, double to) const {
    std::vector<std::size_t> result;
    for (std::size_t v = first_after(from); at(v) < to - same_place_mm; ++v) result.push_back(v);
    return result;
  }
  std::size_t first_after(double s) const {
    const std::size_t round = s + same_place_mm >= total_ ? 1 : 0;
    const double rest = s - static_cast<double>(round) * total_ + same_place_mm;
    return round * count() + static_cast<std::size_t>(std::upper_bound(at_.begin(), at_.end() - 1, rest) - at_.begin());
  }

 private:
  static constexpr double same_place_mm = 0.01;

  vec2 normal_before(std::size_t vertex) const { return normals_[(vertex + count() - 1) % count()]; }

  Polygon points_;
  std::vector<double> at_;
  std::vector<vec2> normals_;  // of the edge after each point
  double total_ = 0.0;
};

// Where perpends stand between two lengths of the line, with the two.
std::vector<double> section_stops(double from, double to, double stone_mm, double phase, bool corners) {
  const double count = std::max(1.0, std::round((to - from) / stone_mm));
  const double step = (to - from) / count;
  std::vector<double> stops;
  if (corners) stops.push_back(from);
  // By whole numbers; a stone thinner than a quarter is not begun with.
  for (double i = 0.0; i <= count; i += 1.0) {
    const double s = from + (i + phase) * step;
    const bool inside = s > from + 0.2 * step && s < to - 0.2 * step;
    if (corners ? inside : i < count) stops.push_back(s);
  }
  stops.push_back(corners ? to : stops.front() + (to - from));
  return stops;
}

// Takes a stop that stands on the mitre of a bend, or just beside it, to the bend, so that sides do not cross.
double off_bends(const Line& line, double stop, double half_depth) {
  const std::size_t after = line.first_after(stop);
  for (const std::size_t vertex : {after, after + line.count() - 1}) {
    const double cosine = line.turn_cosine(vertex);
    if (cosine > bend_cosine) continue;
    const double reach = half_depth * std::sqrt((1.0 - cosine) / (1.0 + cosine)) + 1.0;
    double at = line.at(vertex);
    if (at - stop > line.total() / 2) at -= line.total();
    if (std::abs(at - stop) < reach && at >= 0.0) return at;
  }
  return stop;
}

Tile tile_between(const Line& line, double from, double to, double half_depth) {
  std::vector<Line::Cross> crosses{line.at_length(from)};
  for (const std::size_t vertex : line.between(from, to)) crosses.push_back(line.at_vertex(vertex));
  crosses.push_back(line.at_length(to));
  Tile tile;
  for (const Line::Cross& c : crosses) tile.outline_mm.push_back(geometry::on_lattice(c.place - half_depth * c.mitre));
  std::ranges::reverse(crosses);
  for (const Line::Cross& c : crosses) tile.outline_mm.push_back(geometry::on_lattice(c.place + half_depth * c.mitre));
  tile.outline_mm = geometry::cleaned(tile.outline_mm);
  const vec2 chord = crosses.front().place - crosses.back().place;
  if (glm::length(chord) > 0.0) tile.axis = chord / glm::length(chord);
  return tile;
}

// Whether a line along a side of `a` has `a` on its left and `b` on its right, but for rounding.
bool side_separates(const Polygon& a, const Polygon& b) {
  constexpr double rounding_mm = 0.003;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const vec2 d = a[(i + 1) % a.size()] - a[i];
    const double slack = rounding_mm * glm::length(d);
    const auto left = [&](vec2 p) { return cross(d, p - a[i]); };
    if (std::ranges::all_of(b, [&](vec2 p) { return left(p) <= slack; }) &&
        std::ranges::all_of(a, [&](vec2 p) { return left(p) >= -slack; })) {
      return true;
    }
  }
  return false;
}

bool overlap(const Polygon& a, const Polygon& b) {
  if (!geometry::boxes_meet(geometry::bounding_box(a), geometry::bounding_box(b))) return false;
  if (side_separates(a, b) || side_separates(b, a)) return false;
  // Sides that were rounded for each tile leave slivers in common: 1.4 µm times the length of a stone at the most.
  constexpr double sliver_mm2 = 5e-4;
  double common = 0.0;
  for (const geometry::Region& part : geometry::intersection(a, {b, {}})) common += geometry::area(part);
  return common > sliver_mm2;
}

}  // namespace

std::vector<Tile> course_tiles(const Polygon& middle, vec2 pitch, double phase) {
  if (middle.size() < 3) return {};
  const Line line(middle);
  std::vector<double> corners;
  for (std::size_t v = 0; v < line.count(); ++v) {
    if (line.turn_cosine(v) < sharp_cosine) corners.push_back(line.at(v));
  }
  const bool sharp = !corners.empty();
  if (!sharp) corners.push_back(0.0);
  corners.push_back(corners.front() + line.total());
  std::vector<Tile> tiles;
  for (std::size_t c = 0; c + 1 < corners.size(); ++c) {
    auto stops = section_stops(corners[c], corners[c + 1], pitch.x, phase, sharp);
    for (double& stop : stops) stop = off_bends(line, stop, 0.5 * pitch.y);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      if (stops[i + 1] <= stops[i]) continue;
      Tile tile = tile_between(line, stops[i], stops[i + 1], 0.5 * pitch.y);
      if (geometry::is_simple(tile.outline_mm) && geometry::area(tile.outline_mm) > 0.0) tiles.push_back(std::move(tile));
    }
  }
  return tiles;
}

std::vector<Tile> without_overlaps(std::vector<Tile> tiles, double pitch_mm) {
  NearIndex near(3.0 * pitch_mm, tiles.size());
  std::vector<Tile> kept;
  std::vector<std::uint32_t> found;
  for (Tile& tile : tiles) {
    const vec2 centre = geometry::centroid(tile.outline_mm);
    found.clear();
    near.for_each_near(centre, [&](std::uint32_t k) {
      if (overlap(kept[k].outline_mm, tile.outline_mm)) found.push_back(k);
    });
    std::vector<Polygon> parts{tile.outline_mm};
    if (!found.empty()) {
      std::vector<Polygon> others;
      others.reserve(found.size());
      for (const std::uint32_t k : found) others.push_back(kept[k].outline_mm);
      parts.clear();
      for (geometry::Region& part : geometry::difference({tile.outline_mm, {}}, others)) {
        if (part.holes.empty()) parts.push_back(std::move(part.outline));
      }
    }
    for (Polygon& part : parts) {
      near.add(geometry::centroid(part));
      kept.push_back({std::move(part), tile.axis});
    }
  }
  return kept;
}

}  // namespace shatterpave::paving
