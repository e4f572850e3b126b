#include "trace/cracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/angle.h"
#include "core/error.h"

namespace shatterpave::trace {

namespace {

using glass::CrackKind;
using glass::radiality;

constexpr double straight_on_deg = 40.0;
constexpr double junction_reach_px = 10.0;

// The graph without what lies within the hub: edges that enter it end at its rim.
LineGraph outside_hub(const LineGraph& graph, vec2 impact, double hub_px) {
  LineGraph result{Mask(1, 1)};
  std::vector<std::size_t> nodes(graph.nodes().size(), none);
  const auto node_of = [&](std::size_t node) {
    if (nodes[node] == none) nodes[node] = result.add_node(graph.nodes()[node].at);
    return nodes[node];
  };
  const auto is_out = [&](vec2 p) { return glm::length(p - impact) > hub_px; };
  const auto add_stretch = [&](const GraphEdge& edge, std::size_t first, std::size_t last) {
    if (last - first < 2) return;
    const std::size_t from = first == 0 ? node_of(edge.from) : result.add_node(edge.points[first]);
    const std::size_t to = last == edge.points.size() ? node_of(edge.to) : result.add_node(edge.points[last - 1]);
    const auto begin = edge.points.begin();
    result.add_edge(from, to, {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last)});
  };
  for (const GraphEdge& edge : graph.edges()) {
    if (!edge.alive) continue;
    for (std::size_t i = 0; i < edge.points.size();) {
      const auto in = std::find_if_not(edge.points.begin() + static_cast<std::ptrdiff_t>(i), edge.points.end(), is_out);
      const auto last = static_cast<std::size_t>(in - edge.points.begin());
      add_stretch(edge, i, last);
      i = last + 1;
    }
  }
  return result;
}

// An edge and the end of it at which one arrives.
struct Arrival {
  std::size_t edge = none;
  bool at_end = true;

  bool operator==(const Arrival&) const = default;
};

// For both ends of each edge, the one that goes on straight from there.
class Continuations {
 public:
  Continuations(const LineGraph& graph, vec2 impact) : graph_(graph), next_(graph.edges().size()) {
    for (const GraphEdge& edge : graph.edges()) radiality_.push_back(edge.alive ? radiality(edge.points, impact) : 0.0);
    for (std::size_t node = 0; node < graph.nodes().size(); ++node) pair_at(node);
  }

  // Where one comes out who goes on from there; an edge of `none` where nothing goes on.
  Arrival next(Arrival from) const { return next_[from.edge][from.at_end ? 1 : 0]; }

 private:
  struct Pair {
    double cosine = 0.0;
    std::size_t one = 0;
    std::size_t two = 0;
  };

  std::vector<Arrival> ends_at(std::size_t node) const {
    std::vector<Arrival> ends;
    for (const std::size_t edge : graph_.nodes()[node].edges) {
      const bool at_end = graph_.edges()[edge].to == node && !(graph_.edges()[edge].from == node && contains(ends, edge));
      ends.push_back({edge, at_end});
    }
    return ends;
  }
  static bool contains(const std::vector<Arrival>& ends, std::size_t edge) {
    return std::ranges::any_of(ends, [&](const Arrival& end) { return end.edge == edge; });
  }

  // A line that leaves the impact does not become one that runs round it.
  bool may_be_one(std::size_t one, std::size_t two) const {
    constexpr double clear = 0.35;
    const double a = radiality_[one];
    const double b = radiality_[two];
    return !((a > clear && b < -clear) || (a < -clear && b > clear));
  }

  void pair_at(std::size_t node) {
    const std::vector<Arrival> ends = ends_at(node);
    if (ends.size() < 2) return;
    const double least = Angle::degrees(straight_on_deg).direction().x;
    std::vector<vec2> ways(ends.size());
    std::ranges::transform(ends, ways.begin(), [&](const Arrival& end) {
      return graph_.direction_from(end.edge, node, end.at_end, junction_reach_px);
    });
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t j = i + 1; j < ends.size(); ++j) {
        const double cosine = -glm::dot(ways[i], ways[j]);
        if (cosine >= least && ends[i].edge != ends[j].edge && may_be_one(ends[i].edge, ends[j].edge)) {
          pairs.push_back({cosine, i, j});
        }
      }
    }
    std::ranges::sort(pairs, [](const Pair& a, const Pair& b) {
      return std::tie(b.cosine, a.one, a.two) < std::tie(a.cosine, b.one, b.two);
    });
    std::vector<bool> taken(ends.size(), false);
    for (const Pair& pair : pairs) {
      if (taken[pair.one] || taken[pair.two]) continue;
      taken[pair.one] = taken[pair.two] = true;
      const Arrival one = ends[pair.one];
      const Arrival two = ends[pair.two];
      next_[one.edge][one.at_end ? 1 : 0] = {two.edge, !two.at_end};
      next_[two.edge][two.at_end ? 1 : 0] = {one.edge, !one.at_end};
    }
  }

  const LineGraph& graph_;
  std::vector<std::array<Arrival, 2>> next_;
  std::vector<double> radiality_;
};

struct Way {
  std::vector<vec2> points;
  std::size_t first_node = 0;
  std::size_t last_node = 0;
};

void append(const GraphEdge& edge, bool forward, std::vector<vec2>& points) {
  if (forward) {
    points.insert(points.end(), edge.points.begin() + (points.empty() ? 0 : 1), edge.points.end());
  } else {
    points.insert(points.end(), edge.points.rbegin() + (points.empty() ? 0 : 1), edge.points.rend());
  }
}

std::vector<Way> ways_of(const LineGraph& graph, const Continuations& continuations) {
  std::vector<bool> done(graph.edges().size(), false);
  std::vector<Way> ways;
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    if (!graph.edges()[i].alive || done[i]) continue;
    // Back to where the line begins, which in a ring is where one began.
    Arrival first{i, false};
    for (Arrival back = continuations.next(first); back.edge != none && back.edge != i; back = continuations.next(back)) {
      first = back;
    }
    Arrival at{first.edge, !first.at_end};
    Way way;
    way.first_node = first.at_end ? graph.edges()[first.edge].to : graph.edges()[first.edge].from;
    while (at.edge != none && !done[at.edge]) {
      done[at.edge] = true;
      append(graph.edges()[at.edge], at.at_end, way.points);
      way.last_node = at.at_end ? graph.edges()[at.edge].to : graph.edges()[at.edge].from;
      at = continuations.next(at);
    }
    ways.push_back(std::move(way));
  }
  return ways;
}

// What comes near the impact and leaves it again is two lines: gaps between lines that end about the impact may have been
// bridged.
std::vector<Way> split_at_impact(std::vector<Way> ways, vec2 impact) {
  constexpr double nearer = 0.6;  // than both ends
  std::vector<Way> result;
  for (Way& way : ways) {
    const auto distance = [&](vec2 p) { return glm::length(p - impact); };
    const auto nearest = std::ranges::min_element(way.points, {}, distance);
    if (distance(*nearest) < nearer * std::min(distance(way.points.front()), distance(way.points.back()))) {
      result.push_back({{nearest, way.points.end()}, none, way.last_node});
      way.points.erase(nearest + 1, way.points.end());
      way.last_node = none;
    }
    result.push_back(std::move(way));
  }
  return result;
}

// The mean of three points each, its ends as they are: a skeleton goes in steps of a pixel.
std::vector<vec2> smooth(const std::vector<vec2>& points) {
  const std::size_t count = points.size();
  std::vector<vec2> result = points;
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const std::size_t reach = std::min({std::size_t{1}, i, count - 1 - i});
    vec2 sum{0.0, 0.0};
    for (std::size_t k = i - reach; k <= i + reach; ++k) sum += points[k];
    result[i] = sum / static_cast<double>(2 * reach + 1);
  }
  return result;
}

class Classifier {
 public:
  Classifier(const CrackRules& rules, int width, int height) : rules_(rules), width_(width), height_(height) {}

  bool at_hub(vec2 p) const { return glm::length(p - rules_.impact) <= 1.25 * rules_.hub_px + 5.0; }

  bool at_border(vec2 p) const {
    return p.x <= rules_.edge_px || p.y <= rules_.edge_px || p.x >= width_ - rules_.edge_px || p.y >= height_ - rules_.edge_px;
  }

  // Short, or where radials run together: their borders touch there, which looks like lines across.
  bool is_rung(const std::vector<vec2>& points) const {
    if (length_of(points) < rules_.least_ring_px) return true;
    return std::ranges::all_of(points, [&](vec2 p) { return glm::length(p - rules_.impact) <= rules_.merged_px; });
  }

  // Along the border: of the frame, not of the glass.
  bool is_frame(const std::vector<vec2>& points) const {
    const auto near = static_cast<std::size_t>(std::ranges::count_if(points, [&](vec2 p) { return at_border(p); }));
    return 10 * near >= 7 * points.size();
  }

  // From the end on to the border, straight on.
  void go_on_to_border(std::vector<vec2>& points) const {
    const vec2 end = points.back();
    vec2 nearest = end;
    double least = rules_.edge_px;
    for (const vec2 on : {vec2{0.0, end.y}, vec2{static_cast<double>(width_), end.y}, vec2{end.x, 0.0},
                          vec2{end.x, static_cast<double>(height_)}}) {
      if (glm::length(on - end) > least) continue;
      least = glm::length(on - end);
      nearest = on;
    }
    if (nearest != end) points.push_back(nearest);
  }

 private:
  const CrackRules& rules_;
  double width_;
  double height_;
};

// Whether another line that meets the node comes there from the impact.
bool leaves_radial(const LineGraph& graph, std::size_t node, vec2 impact) {
  if (node == none) return false;
  const vec2 out = graph.nodes()[node].at - impact;
  return std::ranges::any_of(graph.nodes()[node].edges, [&](std::size_t edge) {
    const vec2 way = graph.direction_from(edge, node, graph.edges()[edge].to == node, 2.0 * junction_reach_px);
    return glm::dot(way, out) < -0.8 * glm::length(out);
  });
}

// The angle at which a line leaves the line that it starts on, told by where both go: between the way to the impact and its
// own.
double leaving_deg(const std::vector<vec2>& points, vec2 impact) {
  const std::size_t reach = std::min<std::size_t>(points.size() - 1, 40);
  const vec2 way = points[reach] - points.front();
  const vec2 out = points.front() - impact;
  const double cosine = glm::dot(way, out) / std::max(glm::length(way) * glm::length(out), 1e-9);
  return Angle::of({cosine, std::sqrt(std::max(1.0 - cosine * cosine, 0.0))}).degrees();
}

// A way that runs towards the impact or away from it, from its inner end.
glass::DrawnCrack radial_crack(Way& way, const LineGraph& graph, const CrackRules& rules, const FeaturePoints& features,
                               const Classifier& classifier) {
  if (glm::length(way.points.back() - rules.impact) < glm::length(way.points.front() - rules.impact)) {
    std::ranges::reverse(way.points);
    std::swap(way.first_node, way.last_node);
  }
  glass::DrawnCrack crack;
  const double inner = glm::length(way.points.front() - rules.impact);
  const bool branches = inner > rules.merged_px && leaves_radial(graph, way.first_node, rules.impact) &&
                        leaving_deg(way.points, rules.impact) >= 15.0;
  if (classifier.at_hub(way.points.front())) crack.points_mm.push_back(rules.impact);
  const std::vector<vec2> points = smooth(features(way.points));
  crack.points_mm.insert(crack.points_mm.end(), points.begin(), points.end());
  const bool reaches = classifier.at_border(crack.points_mm.back());
  if (reaches) classifier.go_on_to_border(crack.points_mm);
  const CrackKind kind = reaches ? CrackKind::large : CrackKind::radial;
  crack.kind = branches ? CrackKind::branch : kind;
  return crack;
}

// A way that runs across.
glass::DrawnCrack ring_crack(const Way& way, const FeaturePoints& features, const Classifier& classifier) {
  glass::DrawnCrack crack;
  crack.kind = CrackKind::circular;
  crack.points_mm = smooth(features(way.points));
  if (classifier.at_border(crack.points_mm.back())) classifier.go_on_to_border(crack.points_mm);
  if (classifier.at_border(crack.points_mm.front())) {
    std::ranges::reverse(crack.points_mm);
    classifier.go_on_to_border(crack.points_mm);
  }
  return crack;
}

}  // namespace

std::vector<glass::DrawnCrack> cracks_of(const LineGraph& whole, const CrackRules& rules, const FeaturePoints& features,
                                         int width, int height) {
  const LineGraph graph = outside_hub(whole, rules.impact, rules.hub_px);
  const Continuations continuations(graph, rules.impact);
  const Classifier classifier(rules, width, height);
  std::vector<glass::DrawnCrack> cracks;
  for (Way& way : split_at_impact(ways_of(graph, continuations), rules.impact)) {
    if (way.points.size() < 2 || classifier.is_frame(way.points)) continue;
    if (radiality(way.points, rules.impact) > 0.0) {
      cracks.push_back(radial_crack(way, graph, rules, features, classifier));
    } else if (!classifier.is_rung(way.points)) {
      cracks.push_back(ring_crack(way, features, classifier));
    }
  }
  return cracks;
}

}  // namespace shatterpave::trace
