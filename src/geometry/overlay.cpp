#include "geometry/overlay.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "core/error.h"
#include "geometry/clip.h"
#include "geometry/predicates.h"
#include "geometry/segment_index.h"

namespace shatterpave::geometry {

namespace {

__extension__ using Wide = __int128;

constexpr std::size_t unbounded = Overlay::outside;

// ---- crossings and pixels

// numerator / denominator to the nearest whole number, halves up; denominator > 0.
std::int64_t nearest_quotient(Wide numerator, Wide denominator) {
  const Wide doubled = 2 * numerator + denominator;
  Wide quotient = doubled / (2 * denominator);
  if (doubled < 0 && quotient * 2 * denominator != doubled) --quotient;
  return static_cast<std::int64_t>(quotient);
}

Wide cross_of(LatticePoint o, LatticePoint p, LatticePoint q) {
  return static_cast<Wide>(p.x - o.x) * (q.y - o.y) - static_cast<Wide>(p.y - o.y) * (q.x - o.x);
}

// The point where two segments cross properly, rounded.
LatticePoint crossing(const Segment& s, const Segment& t) {
  Wide along = cross_of(t.a, t.b, s.a);
  Wide whole = along - cross_of(t.a, t.b, s.b);
  if (whole < 0) {
    along = -along;
    whole = -whole;
  }
  return {s.a.x + nearest_quotient(along * (s.b.x - s.a.x), whole), s.a.y + nearest_quotient(along * (s.b.y - s.a.y), whole)};
}

// A place on a segment as a fraction of it; denominator > 0.
struct Fraction {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;

  friend bool operator<(Fraction a, Fraction b) {
    return static_cast<Wide>(a.numerator) * b.denominator < static_cast<Wide>(b.numerator) * a.denominator;
  }
};

// An interval of a segment, which may be open at either end.
struct Stretch {
  Fraction from{0, 1};
  Fraction to{1, 1};
  bool from_open = false;
  bool to_open = false;

  bool is_empty() const { return to < from || (!(from < to) && (from_open || to_open)); }
  bool begins_before(const Stretch& other) const {
    if (from < other.from || other.from < from) return from < other.from;
    return !from_open && other.from_open;
  }
  void cut(const Stretch& other) {
    if (from < other.from || (!(other.from < from) && other.from_open)) {
      from = other.from;
      from_open = other.from_open;
    }
    if (other.to < to || (!(to < other.to) && other.to_open)) {
      to = other.to;
      to_open = other.to_open;
    }
  }
};

// Where a coordinate that goes from a to b lies in [p − ½, p + ½); nothing if nowhere.
std::optional<Stretch> stretch_within(std::int64_t a, std::int64_t b, std::int64_t p) {
  const std::int64_t run = 2 * (b - a);
  const std::int64_t low = 2 * (p - a) - 1;
  const std::int64_t high = low + 2;
  if (run == 0) return low <= 0 && 0 < high ? std::optional(Stretch{}) : std::nullopt;
  if (run > 0) return Stretch{{low, run}, {high, run}, false, true};
  return Stretch{{-high, -run}, {-low, -run}, true, false};
}

// The part of the segment in the pixel of a lattice point, if there is one. Pixels have no point in common, so these parts come
// one after the other.
std::optional<Stretch> part_within(const Segment& s, LatticePoint pixel) {
  const auto x = stretch_within(s.a.x, s.b.x, pixel.x);
  const auto y = stretch_within(s.a.y, s.b.y, pixel.y);
  if (!x || !y) return std::nullopt;
  Stretch inside;
  inside.cut(*x);
  inside.cut(*y);
  return inside.is_empty() ? std::nullopt : std::optional(inside);
}

double grid_size_mm(std::span<const Segment> segments) {
  double total = 0.0;
  for (const Segment& s : segments) total += glm::length(to_mm(s.b) - to_mm(s.a));
  return std::max(0.01, total / static_cast<double>(std::max<std::size_t>(segments.size(), 1)));
}

// The vertices and crossings of all segments, each once, in order.
std::vector<LatticePoint> hot_points(std::span<const Segment> segments, double grid_mm) {
  std::vector<LatticePoint> points;
  SegmentIndex index(grid_mm);
  std::vector<int> seen(segments.size(), -1);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    points.push_back(s.a);
    points.push_back(s.b);
    index.visit_near(s.a, s.b, [&](int other) {
      if (std::exchange(seen[static_cast<std::size_t>(other)], static_cast<int>(i)) == static_cast<int>(i)) return;
      const Segment& t = segments[static_cast<std::size_t>(other)];
      if (segments_cross(s.a, s.b, t.a, t.b)) points.push_back(crossing(s, t));
    });
    index.add(s);
  }
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// ---- nodes

// Of each segment, the points that it bends to, from its a to its b.
std::vector<std::vector<LatticePoint>> bent(std::span<const Segment> segments) {
  const double grid_mm = grid_size_mm(segments);
  const std::vector<LatticePoint> points = hot_points(segments, grid_mm);
  SegmentIndex index(grid_mm);
  for (const LatticePoint& p : points) {
    // A cross of one unit each way, so that a question from next to it finds it.
    index.add({{p.x - 1, p.y - 1}, {p.x + 1, p.y + 1}});
  }
  std::vector<std::vector<LatticePoint>> ways(segments.size());
  std::vector<std::pair<Stretch, LatticePoint>> found;
  std::vector<int> near;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    near.clear();
    index.visit_near(s.a, s.b, [&](int number) { near.push_back(number); });
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    found.clear();
    for (const int number : near) {
      const LatticePoint p = points[static_cast<std::size_t>(number)];
      if (const auto part = part_within(s, p)) found.emplace_back(*part, p);
    }
    std::ranges::sort(found, [](const auto& a, const auto& b) { return a.first.begins_before(b.first); });
    for (const auto& [part, p] : found) ways[i].push_back(p);
  }
  return ways;
}

// How often a layer runs along a side, less how often it runs against it.
struct Run {
  std::size_t side = 0;
  std::uint32_t layer = 0;
  int times = 0;
};

struct Noded {
  std::vector<Segment> sides;
  std::vector<Run> runs;  // in order of sides, then layers; none of 0 times
};

// A side of a layer, from its lesser end.
struct Step {
  LatticePoint a;
  LatticePoint b;
  std::uint32_t layer = 0;
  int times = 0;  // 1 where the layer runs from a to b, else −1
};

std::vector<Segment> sides_of_layers(std::span<const Layer> layers) {
  std::vector<Segment> segments;
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    for (const Polygon& ring : layers[layer]) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Segment s{to_lattice(ring[i]), to_lattice(ring[(i + 1) % ring.size()]), static_cast<int>(layer)};
        if (s.a != s.b) segments.push_back(s);
      }
    }
  }
  return segments;
}

// In order of their ends and layers.
std::vector<Step> steps_of(std::span<const Segment> segments) {
  std::vector<Step> steps;
  const auto ways = bent(segments);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t k = 0; k + 1 < ways[i].size(); ++k) {
      const auto [a, b] = std::minmax(ways[i][k], ways[i][k + 1]);
      steps.push_back({a, b, static_cast<std::uint32_t>(segments[i].owner), a == ways[i][k] ? 1 : -1});
    }
  }
  std::ranges::sort(steps,
                    [](const Step& p, const Step& q) { return std::tie(p.a, p.b, p.layer) < std::tie(q.a, q.b, q.layer); });
  return steps;
}

Noded noded_sides(std::span<const Layer> layers) {
  Noded result;
  for (const Step& step : steps_of(sides_of_layers(layers))) {
    if (result.sides.empty() || result.sides.back().a != step.a || result.sides.back().b != step.b) {
      result.sides.push_back({step.a, step.b});
    }
    const std::size_t side = result.sides.size() - 1;
    if (result.runs.empty() || result.runs.back().side != side || result.runs.back().layer != step.layer) {
      result.runs.push_back({side, step.layer, 0});
    }
    result.runs.back().times += step.times;
  }
  std::erase_if(result.runs, [](const Run& run) { return run.times == 0; });
  return result;
}

// ---- faces and what covers them

std::vector<std::array<std::size_t, 2>> faces_beside(std::size_t sides, std::span<const Face> faces) {
  std::vector<std::array<std::size_t, 2>> beside(sides, {unbounded, unbounded});
  const auto note = [&](const FaceRing& ring, std::size_t face) {
    for (const FaceSide& side : ring) beside[side.segment][side.forward ? 0 : 1] = face;
  };
  for (std::size_t f = 0; f < faces.size(); ++f) {
    note(faces[f].outline, f);
    for (const FaceRing& hole : faces[f].holes) note(hole, f);
    for (const std::size_t spur : faces[f].spurs) beside[spur] = {f, f};
  }
  return beside;
}

using Windings = std::vector<std::pair<std::uint32_t, int>>;  // layers, ascending, none of 0

// The winding numbers on the left of a side from those on its right (`sign` 1), or the other way round (−1).
Windings across(const Windings& from, std::span<const Run> runs, int sign) {
  Windings result;
  std::size_t i = 0;
  std::size_t k = 0;
  while (i < from.size() || k < runs.size()) {
    const bool has_both = i < from.size() && k < runs.size() && from[i].first == runs[k].layer;
    if (has_both) {
      const int times = from[i].second + sign * runs[k].times;
      if (times != 0) result.emplace_back(from[i].first, times);
      ++i;
      ++k;
    } else if (k == runs.size() || (i < from.size() && from[i].first < runs[k].layer)) {
      result.push_back(from[i++]);
    } else {
      result.emplace_back(runs[k].layer, sign * runs[k].times);
      ++k;
    }
  }
  return result;
}

// Winding numbers of all faces, from the outside inwards, side by side.
class Covering {
 public:
  Covering(const Overlay& map, const std::vector<Run>& runs)
      : map_(map),
        runs_(runs),
        first_(map.sides.size() + 1, 0),
        reached_(map.faces.size(), false),
        windings_(map.faces.size()) {
    for (const Run& run : runs) ++first_[run.side + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  std::vector<Windings> windings() && {
    std::vector<std::vector<std::size_t>> sides_of(map_.faces.size());
    for (std::size_t s = 0; s < map_.sides.size(); ++s) {
      const auto [left, right] = map_.beside[s];
      if (left == right) continue;
      if (left != unbounded) sides_of[left].push_back(s);
      if (right != unbounded) sides_of[right].push_back(s);
      if (left == unbounded || right == unbounded) cross_from(unbounded, s);
    }
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const std::size_t face = order_[k];
      for (const std::size_t s : sides_of[face]) cross_from(face, s);
    }
    return std::move(windings_);
  }

 private:
  void cross_from(std::size_t face, std::size_t side) {
    const bool on_right = map_.beside[side][1] == face;
    const std::size_t to = map_.beside[side][on_right ? 0 : 1];
    if (to == unbounded || reached_[to]) return;
    reached_[to] = true;
    const std::span<const Run> runs{runs_.data() + first_[side], first_[side + 1] - first_[side]};
    windings_[to] = across(face == unbounded ? Windings{} : windings_[face], runs, on_right ? 1 : -1);
    order_.push_back(to);
  }

  const Overlay& map_;
  const std::vector<Run>& runs_;
  std::vector<std::size_t> first_;  // run of each side
  std::vector<bool> reached_;
  std::vector<std::size_t> order_;  // in which faces were reached
  std::vector<Windings> windings_;
};

std::vector<std::vector<std::uint32_t>> covers(const Overlay& map, const std::vector<Run>& runs) {
  std::vector<std::vector<std::uint32_t>> covered_by(map.faces.size());
  const std::vector<Windings> windings = Covering(map, runs).windings();
  for (std::size_t f = 0; f < map.faces.size(); ++f) {
    for (const auto& [layer, times] : windings[f]) covered_by[f].push_back(layer);
  }
  return covered_by;
}

// ---- labels

// Connected sets of faces.
class FaceSets {
 public:
  explicit FaceSets(std::size_t count) : rank_(count), parent_(count), sets_(rank_.data(), parent_.data()) {
    for (std::size_t i = 0; i < count; ++i) sets_.make_set(i);
  }
  std::size_t of(std::size_t face) { return sets_.find_set(face); }
  void join(std::size_t a, std::size_t b) { sets_.union_set(a, b); }

 private:
  std::vector<std::size_t> rank_;
  std::vector<std::size_t> parent_;
  boost::disjoint_sets<std::size_t*, std::size_t*> sets_;
};

FaceSets sets_of(const Overlay& map, std::span<const std::uint32_t> label) {
  FaceSets sets(map.faces.size());
  for (const auto& [left, right] : map.beside) {
    if (left != unbounded && right != unbounded && label[left] == label[right]) sets.join(left, right);
  }
  return sets;
}

double length_mm(const Segment& s) { return glm::length(to_mm(s.b) - to_mm(s.a)); }

Polygon ring_polygon(const FaceRing& ring) {
  Polygon polygon;
  for (const FaceSide& side : ring) polygon.push_back(to_mm(side.from));
  return polygon;
}

// The measures of sets of faces.
struct SetMeasures {
  std::map<std::size_t, double> area_mm2;
  std::map<std::size_t, double> border_mm;
  std::map<std::pair<std::size_t, std::size_t>, double> shared_mm;  // of two sets, both ways
};

SetMeasures measures_of(const Overlay& map, FaceSets& sets) {
  SetMeasures result;
  for (std::size_t f = 0; f < map.faces.size(); ++f) {
    result.area_mm2[sets.of(f)] += 0.5e-6 * static_cast<double>(doubled_area(map.faces[f]));
  }
  for (std::size_t s = 0; s < map.sides.size(); ++s) {
    const auto [left, right] = map.beside[s];
    const std::size_t a = left == unbounded ? unbounded : sets.of(left);
    const std::size_t b = right == unbounded ? unbounded : sets.of(right);
    if (a == b) continue;
    const double length = length_mm(map.sides[s]);
    if (a != unbounded) result.border_mm[a] += length;
    if (b != unbounded) result.border_mm[b] += length;
    if (a == unbounded || b == unbounded) continue;
    result.shared_mm[{a, b}] += length;
    result.shared_mm[{b, a}] += length;
  }
  return result;
}

// The set that takes a sliver: of the larger ones beside it, so that no two take each other, that with most of its border.
std::optional<std::size_t> taker_of(std::size_t sliver, SetMeasures& measures, std::span<const std::uint32_t> label,
                                    std::uint32_t fixed) {
  const auto rank = [&](std::size_t set) { return std::pair(measures.area_mm2[set], set); };
  std::optional<std::size_t> taker;
  double most = 0.0;
  for (auto pair = measures.shared_mm.lower_bound({sliver, 0}); pair != measures.shared_mm.end(); ++pair) {
    const auto [own, other] = pair->first;
    if (own != sliver) break;
    if (label[other] == fixed || pair->second <= most || rank(other) < rank(sliver)) continue;
    most = pair->second;
    taker = other;
  }
  return taker;
}

}  // namespace

Overlay overlay(std::span<const Layer> layers) {
  Noded nodes = noded_sides(layers);
  Overlay map;
  map.sides = std::move(nodes.sides);
  map.faces = faces(map.sides);
  map.beside = faces_beside(map.sides.size(), map.faces);
  map.covered_by = covers(map, nodes.runs);
  return map;
}

std::vector<LabelledRegion> labelled_regions(const Overlay& map, std::span<const std::uint32_t> label) {
  FaceSets sets = sets_of(map, label);
  std::vector<Segment> borders;
  std::vector<std::size_t> side_of;
  for (std::size_t s = 0; s < map.sides.size(); ++s) {
    const auto [left, right] = map.beside[s];
    if (left == right || (left != unbounded && right != unbounded && sets.of(left) == sets.of(right))) continue;
    borders.push_back(map.sides[s]);
    side_of.push_back(s);
  }
  std::vector<LabelledRegion> result;
  for (const Face& face : faces(borders)) {
    const FaceSide& one = face.outline.front();
    const std::size_t inside = map.beside[side_of[one.segment]][one.forward ? 0 : 1];
    ENSURE(inside != unbounded);
    LabelledRegion& part = result.emplace_back();
    part.label = label[inside];
    part.region.outline = ring_polygon(face.outline);
    for (const FaceRing& hole : face.holes) part.region.holes.push_back(ring_polygon(hole));
  }
  return result;
}

std::vector<std::uint32_t> without_slivers(const Overlay& map, std::vector<std::uint32_t> label, double width_mm,
                                           std::uint32_t fixed) {
  FaceSets sets = sets_of(map, label);
  SetMeasures measures = measures_of(map, sets);
  std::map<std::size_t, std::size_t> taker;
  for (const auto& [set, size] : measures.area_mm2) {
    if (label[set] == fixed || size >= 0.5 * measures.border_mm[set] * width_mm) continue;
    if (const auto takes = taker_of(set, measures, label, fixed)) taker[set] = *takes;
  }
  const std::vector<std::uint32_t> before = label;
  for (std::size_t f = 0; f < map.faces.size(); ++f) {
    std::size_t set = sets.of(f);
    for (auto next = taker.find(set); next != taker.end(); next = taker.find(set)) set = next->second;
    label[f] = before[set];
  }
  return label;
}

}  // namespace shatterpave::geometry
