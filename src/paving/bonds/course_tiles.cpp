#include "paving/bonds/course_tiles.h"

#include <algorithm>
#include <cmath>

#include "geometry/clip.h"
#include "geometry/lattice.h"

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

// A part of the line between two sharp corners, or the whole of it.
struct Section {
  double from = 0.0;  // lengths along the line
  double to = 0.0;
  bool corners = false;
  // How much longer than the middle of the course its longer side is at either end, where it is mitred.
  double more_before = 0.0;
  double more_after = 0.0;
};

// How much longer one side of a course is than its middle where it turns; no more than stones at mitres have room for.
double more_at(const Line& line, std::size_t corner, double half_depth) {
  const double cosine = line.turn_cosine(corner);
  return half_depth * std::min(std::sqrt((1.0 - cosine) / std::max(1.0 + cosine, 1e-9)), longest_mitre);
}

// Lengths along the longer side of a course, whichever that is at each bend, from the beginning of a section.
class LongerSide {
 public:
  LongerSide(const Line& line, const Section& section, double half_depth)
      : from_(section.from - section.more_before),
        length_(section.to - section.from + section.more_before + section.more_after) {
    double more_so_far = 0.0;
    for (const std::size_t vertex : line.between(section.from, section.to)) {
      const double more = 2.0 * more_at(line, vertex, half_depth);
      begins_.push_back(line.at(vertex) - from_ + more_so_far);
      more_so_far += more;
      ends_.push_back(line.at(vertex) - from_ + more_so_far);
      at_.push_back(line.at(vertex));
    }
    length_ += more_so_far;
  }

  double length() const { return length_; }
  // The place on the middle of the course, as a length along its line.
  double place(double along) const {
    const auto after = static_cast<std::size_t>(std::upper_bound(begins_.begin(), begins_.end(), along) - begins_.begin());
    if (after == 0) return from_ + along;
    return at_[after - 1] + std::max(0.0, along - ends_[after - 1]);
  }

 private:
  double from_;
  double length_;
  std::vector<double> begins_;  // of each bend, along the longer side
  std::vector<double> ends_;
  std::vector<double> at_;  // along the line
};

// Where perpends stand in a section, with its two ends. Stones are alike along its longer side.
std::vector<double> section_stops(const Line& line, const Section& section, vec2 pitch, double joint_mm, double phase) {
  constexpr double wider = 0.1;  // of a joint: so much wider they may be, by eye, where stones a little longer would do
  const LongerSide side(line, section, 0.5 * pitch.y);
  const double count = std::max(1.0, std::ceil(side.length() / (pitch.x + wider * joint_mm) - 1e-9));
  const double step = side.length() / count;
  std::vector<double> stops;
  if (section.corners) stops.push_back(section.from);
  // By whole numbers; a stone thinner than a quarter is not begun with.
  for (double i = 0.0; i <= count; i += 1.0) {
    const double s = side.place((i + phase) * step);
    const bool inside = s > section.from + 0.2 * step && s < section.to - 0.2 * step;
    if (section.corners ? inside : i < count) stops.push_back(s);
  }
  stops.push_back(section.corners ? section.to : stops.front() + (section.to - section.from));
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

}  // namespace

std::vector<Tile> course_tiles(const Polygon& middle, vec2 pitch, double joint_mm, double phase) {
  if (middle.size() < 3) return {};
  const Line line(middle);
  const double half_depth = 0.5 * pitch.y;
  std::vector<Section> sections;
  for (std::size_t v = 0; v < line.count(); ++v) {
    if (line.turn_cosine(v) >= sharp_cosine) continue;
    const double more = more_at(line, v, half_depth);
    if (!sections.empty()) {
      sections.back().to = line.at(v);
      sections.back().more_after = more;
    }
    sections.push_back({line.at(v), 0.0, true, more, 0.0});
  }
  if (sections.empty()) {
    sections.push_back({0.0, line.total(), false, 0.0, 0.0});
  } else {
    sections.back().to = sections.front().from + line.total();
    sections.back().more_after = sections.front().more_before;
  }
  std::vector<Tile> tiles;
  for (const Section& section : sections) {
    auto stops = section_stops(line, section, pitch, joint_mm, phase);
    for (double& stop : stops) stop = off_bends(line, stop, half_depth);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      if (stops[i + 1] <= stops[i]) continue;
      Tile tile = tile_between(line, stops[i], stops[i + 1], half_depth);
      if (geometry::is_simple(tile.outline_mm) && geometry::area(tile.outline_mm) > 0.0) tiles.push_back(std::move(tile));
    }
  }
  return tiles;
}

}  // namespace shatterpave::paving
