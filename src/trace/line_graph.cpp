#include "trace/line_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/angle.h"
#include "core/disjoint_sets.h"
#include "core/error.h"

namespace shatterpave::trace {

namespace {

constexpr std::array<std::array<int, 2>, 8> around = {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};

// Reads a skeleton into a graph.
class SkeletonReader {
 public:
  SkeletonReader(const Mask& skeleton, LineGraph& graph)
      : skeleton_(skeleton),
        graph_(graph),
        node_at_(skeleton.width, skeleton.height, none),
        visited_(skeleton.width, skeleton.height) {}

  void read() {
    for_each_pixel([&](int x, int y) {
      if (neighbour_count(x, y) >= 3 && node_at_.at(x, y) == none) add_junction(x, y);
    });
    for_each_pixel([&](int x, int y) {
      const int count = neighbour_count(x, y);
      if (count <= 1 && node_at_.at(x, y) == none) node_at_.at(x, y) = graph_.add_node(middle(x, y));
    });
    for_each_pixel([&](int x, int y) {
      if (node_at_.at(x, y) != none) leave(x, y);
    });
    // What is left are rings without a node.
    for_each_pixel([&](int x, int y) {
      if (visited_.at(x, y) != 0 || node_at_.at(x, y) != none) return;
      node_at_.at(x, y) = graph_.add_node(middle(x, y));
      leave(x, y);
    });
  }

 private:
  static vec2 middle(int x, int y) { return {x + 0.5, y + 0.5}; }
  bool is_on(int x, int y) const { return skeleton_.holds(x, y) && skeleton_.at(x, y) != 0; }

  template <typename Visit>
  void for_each_pixel(Visit visit) const {
    for (int y = 0; y < skeleton_.height; ++y) {
      for (int x = 0; x < skeleton_.width; ++x) {
        if (skeleton_.at(x, y) != 0) visit(x, y);
      }
    }
  }

  // A corner neighbour that an edge neighbour joins counts with that one.
  template <typename Visit>
  void for_each_neighbour(int x, int y, Visit visit) const {
    for (const auto& [dx, dy] : around) {
      if (!is_on(x + dx, y + dy)) continue;
      if (dx != 0 && dy != 0 && (is_on(x + dx, y) || is_on(x, y + dy))) continue;
      visit(x + dx, y + dy);
    }
  }
  int neighbour_count(int x, int y) const {
    int count = 0;
    for_each_neighbour(x, y, [&](int, int) { ++count; });
    return count;
  }

  void add_junction(int x, int y) {
    const std::size_t node = graph_.add_node({0.0, 0.0});
    std::vector<std::array<int, 2>> pixels = {{x, y}};
    node_at_.at(x, y) = node;
    vec2 sum{0.0, 0.0};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const auto [u, v] = pixels[i];
      sum += middle(u, v);
      for (const auto& [dx, dy] : around) {
        const int s = u + dx;
        const int t = v + dy;
        if (!is_on(s, t) || node_at_.at(s, t) != none || neighbour_count(s, t) < 3) continue;
        node_at_.at(s, t) = node;
        pixels.push_back({s, t});
      }
    }
    graph_.move_node(node, sum / static_cast<double>(pixels.size()));
  }

  // Follows every line that leaves the node's pixel.
  void leave(int x, int y) {
    const std::size_t node = node_at_.at(x, y);
    for_each_neighbour(x, y, [&](int u, int v) {
      const std::size_t other = node_at_.at(u, v);
      if (other != none) {
        if (other > node) graph_.add_edge(node, other, {graph_.nodes()[node].at, graph_.nodes()[other].at});
      } else if (visited_.at(u, v) == 0) {
        follow(node, x, y, u, v);
      }
    });
  }

  void follow(std::size_t node, int from_x, int from_y, int x, int y) {
    std::vector<vec2> points = {graph_.nodes()[node].at};
    while (true) {
      visited_.at(x, y) = 1;
      points.push_back(middle(x, y));
      int next_x = -1;
      int next_y = -1;
      std::size_t end = none;
      for_each_neighbour(x, y, [&](int u, int v) {
        if (u == from_x && v == from_y) return;
        const std::size_t there = node_at_.at(u, v);
        if (there != none && (there != node || points.size() > 3)) end = there;
        if (there == none && visited_.at(u, v) == 0) {
          next_x = u;
          next_y = v;
        }
      });
      if (end != none) {
        points.push_back(graph_.nodes()[end].at);
        graph_.add_edge(node, end, std::move(points));
        return;
      }
      if (next_x < 0) return;  // between two pixels of one node
      from_x = x;
      from_y = y;
      x = next_x;
      y = next_y;
    }
  }

  const Mask& skeleton_;
  LineGraph& graph_;
  Grid<std::size_t> node_at_;
  Mask visited_;
};

// The point of a line that is `reach` along it from its first one, or its last.
vec2 point_along(const std::vector<vec2>& points, bool from_end, double reach) {
  const std::size_t count = points.size();
  const auto at = [&](std::size_t i) { return from_end ? points[count - 1 - i] : points[i]; };
  double gone = 0.0;
  for (std::size_t i = 1; i < count; ++i) {
    gone += glm::length(at(i) - at(i - 1));
    if (gone >= reach) return at(i);
  }
  return at(count - 1);
}

double distance_to_line(vec2 p, const std::vector<vec2>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const vec2 ab = points[i] - points[i - 1];
    const double square = glm::dot(ab, ab);
    const double share = square > 0.0 ? std::clamp(glm::dot(p - points[i - 1], ab) / square, 0.0, 1.0) : 0.0;
    least = std::min(least, glm::length(p - points[i - 1] - share * ab));
  }
  return least;
}

// The middle line of two lines with common ends.
std::vector<vec2> middle_line(const std::vector<vec2>& one, std::vector<vec2> two) {
  if (glm::length(one.front() - two.front()) > glm::length(one.front() - two.back())) std::ranges::reverse(two);
  const std::size_t steps = std::max<std::size_t>(std::max(one.size(), two.size()) - 1, 1);
  const double lengths[2] = {length_of(one), length_of(two)};
  std::vector<vec2> middle;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(steps);
    middle.push_back(0.5 * (point_along(one, false, share * lengths[0]) + point_along(two, false, share * lengths[1])));
  }
  middle.front() = one.front();
  middle.back() = one.back();
  return middle;
}

}  // namespace

double length_of(const std::vector<vec2>& points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += glm::length(points[i] - points[i - 1]);
  return sum;
}

double GraphEdge::length() const { return length_of(points); }

LineGraph::LineGraph(const Mask& skeleton) { SkeletonReader(skeleton, *this).read(); }

std::size_t LineGraph::add_node(vec2 at) {
  nodes_.push_back({at, {}});
  return nodes_.size() - 1;
}

void LineGraph::move_node(std::size_t node, vec2 at) { nodes_[node].at = at; }

void LineGraph::add_edge(std::size_t from, std::size_t to, std::vector<vec2> points) {
  ENSURE(points.size() >= 2);
  nodes_[from].edges.push_back(edges_.size());
  nodes_[to].edges.push_back(edges_.size());
  edges_.push_back({from, to, std::move(points), true});
}

void LineGraph::remove(std::size_t edge) {
  edges_[edge].alive = false;
  std::erase(nodes_[edges_[edge].from].edges, edge);
  std::erase(nodes_[edges_[edge].to].edges, edge);
}

void LineGraph::set_points(std::size_t edge, std::vector<vec2> points) { edges_[edge].points = std::move(points); }

std::size_t LineGraph::split(std::size_t edge, std::size_t index) {
  const GraphEdge whole = edges_[edge];
  ENSURE(index > 0 && index + 1 < whole.points.size());
  remove(edge);
  const std::size_t node = add_node(whole.points[index]);
  const auto cut = whole.points.begin() + static_cast<std::ptrdiff_t>(index);
  add_edge(whole.from, node, {whole.points.begin(), cut + 1});
  add_edge(node, whole.to, {cut, whole.points.end()});
  return node;
}

void LineGraph::join_passed_nodes() {
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    if (nodes_[node].edges.size() != 2 || nodes_[node].edges[0] == nodes_[node].edges[1]) continue;
    GraphEdge first = edges_[nodes_[node].edges[0]];
    GraphEdge second = edges_[nodes_[node].edges[1]];
    remove(nodes_[node].edges[1]);
    remove(nodes_[node].edges[0]);
    if (first.to != node) {
      std::swap(first.from, first.to);
      std::ranges::reverse(first.points);
    }
    if (second.from != node) {
      std::swap(second.from, second.to);
      std::ranges::reverse(second.points);
    }
    first.points.insert(first.points.end(), second.points.begin() + 1, second.points.end());
    add_edge(first.from, second.to, std::move(first.points));
  }
}

vec2 LineGraph::direction_from(std::size_t edge, std::size_t node, bool at_end, double reach) const {
  const vec2 away = point_along(edges_[edge].points, at_end, reach) - nodes_[node].at;
  const double length = glm::length(away);
  return length > 0.0 ? away / length : vec2{1.0, 0.0};
}

void take_off_spurs(LineGraph& graph, double least_px) {
  bool changed = true;
  while (changed) {
    changed = false;
    for (std::size_t i = 0; i < graph.edges().size(); ++i) {
      const GraphEdge& edge = graph.edges()[i];
      if (!edge.alive || edge.length() > least_px) continue;
      const bool free_from = graph.nodes()[edge.from].edges.size() == 1;
      const bool free_to = graph.nodes()[edge.to].edges.size() == 1;
      const bool loop = edge.from == edge.to;
      if (!loop && free_from == free_to) continue;
      graph.remove(i);
      changed = true;
    }
    graph.join_passed_nodes();
  }
}

void take_off_crumbs(LineGraph& graph, double least_px) {
  DisjointSets sets(graph.nodes().size());
  for (const GraphEdge& edge : graph.edges()) {
    if (edge.alive) sets.join(edge.from, edge.to);
  }
  std::vector<double> lengths(graph.nodes().size(), 0.0);
  for (const GraphEdge& edge : graph.edges()) {
    if (edge.alive) lengths[sets.of(edge.from)] += edge.length();
  }
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    if (graph.edges()[i].alive && lengths[sets.of(graph.edges()[i].from)] < least_px) graph.remove(i);
  }
}

void join_double_lines(LineGraph& graph, double apart_px) {
  const auto near = [&](const GraphEdge& one, const GraphEdge& two) {
    const auto all = [&](const std::vector<vec2>& points, const std::vector<vec2>& line) {
      return std::ranges::all_of(points, [&](vec2 p) { return distance_to_line(p, line) <= apart_px; });
    };
    return all(one.points, two.points) && all(two.points, one.points);
  };
  for (std::size_t i = 0; i < graph.edges().size(); ++i) {
    if (!graph.edges()[i].alive) continue;
    const std::vector<std::size_t> beside = graph.nodes()[graph.edges()[i].from].edges;
    for (const std::size_t j : beside) {
      const GraphEdge& one = graph.edges()[i];
      const GraphEdge& two = graph.edges()[j];
      if (j == i || !two.alive || one.from == one.to || two.other(one.from) != one.to || !near(one, two)) continue;
      graph.set_points(i, middle_line(one.points, two.points));
      graph.remove(j);
    }
  }
  graph.join_passed_nodes();
}

namespace {

struct FreeEnd {
  std::size_t node = 0;
  vec2 at{0.0, 0.0};
  vec2 outward{1.0, 0.0};
};

constexpr double direction_reach_px = 12.0;

std::vector<FreeEnd> free_ends(const LineGraph& graph) {
  std::vector<FreeEnd> ends;
  for (std::size_t node = 0; node < graph.nodes().size(); ++node) {
    const GraphNode& here = graph.nodes()[node];
    if (here.edges.size() != 1) continue;
    const std::size_t edge = here.edges.front();
    const bool at_end = graph.edges()[edge].to == node;
    ends.push_back({node, here.at, -graph.direction_from(edge, node, at_end, direction_reach_px)});
  }
  return ends;
}

struct Bridge {
  double cost = 0.0;
  std::size_t one = 0;
  std::size_t two = 0;

  auto operator<=>(const Bridge&) const = default;
};

// Free ends by the square of a grid that they lie in.
class EndGrid {
 public:
  EndGrid(const std::vector<FreeEnd>& ends, double side) : side_(side) {
    for (std::size_t i = 0; i < ends.size(); ++i) cells_.emplace_back(cell(ends[i].at), i);
    std::ranges::sort(cells_);
  }
  template <typename Visit>
  void near(vec2 p, Visit visit) const {
    const auto [column, row] = cell(p);
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell wanted{column + dx, row + dy};
        auto at = std::ranges::lower_bound(cells_, std::pair<Cell, std::size_t>{wanted, 0});
        for (; at != cells_.end() && at->first == wanted; ++at) visit(at->second);
      }
    }
  }

 private:
  using Cell = std::pair<int, int>;
  Cell cell(vec2 p) const { return {static_cast<int>(std::floor(p.x / side_)), static_cast<int>(std::floor(p.y / side_))}; }
  double side_;
  std::vector<std::pair<Cell, std::size_t>> cells_;
};

std::vector<Bridge> bridges(const std::vector<FreeEnd>& ends, double gap_px, double least_cosine) {
  const EndGrid grid(ends, gap_px);
  std::vector<Bridge> found;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    grid.near(ends[i].at, [&](std::size_t j) {
      if (j <= i) return;
      const vec2 way = ends[j].at - ends[i].at;
      const double gap = glm::length(way);
      if (gap > gap_px || gap == 0.0) return;
      const double one = glm::dot(way / gap, ends[i].outward);
      const double two = -glm::dot(way / gap, ends[j].outward);
      // A direction over a few pixels is uncertain by a pixel or two.
      const double slack = gap < 6.0 ? 0.3 : 0.0;
      if (one < least_cosine - slack || two < least_cosine - slack) return;
      found.push_back({gap * (3.0 - one - two), i, j});
    });
  }
  std::ranges::sort(found);
  return found;
}

// Where a way straight on from the end first comes to an edge, within `reach`.
struct Landing {
  std::size_t edge = none;
  std::size_t point = 0;
};

// Points of edges by pixel, for ends that go on: the edge and the point's index.
class PointGrid {
 public:
  PointGrid(const LineGraph& graph, double side) : side_(side) {
    for (std::size_t i = 0; i < graph.edges().size(); ++i) {
      if (!graph.edges()[i].alive) continue;
      for (std::size_t k = 0; k < graph.edges()[i].points.size(); ++k)
        points_.push_back({key(graph.edges()[i].points[k]), i, k});
    }
    std::ranges::sort(points_);
  }

  Landing landing(const LineGraph& graph, const FreeEnd& end, double reach, std::size_t own) const {
    Landing best;
    double least = reach;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Key wanted = key(end.at + side_ * vec2{dx, dy});
        auto at = std::ranges::lower_bound(points_, Entry{wanted, 0, 0});
        for (; at != points_.end() && at->key == wanted; ++at) {
          if (at->edge == own) continue;
          const vec2 way = graph.edges()[at->edge].points[at->point] - end.at;
          const double distance = glm::length(way);
          if (distance >= least || glm::dot(way, end.outward) < 0.5 * distance) continue;
          least = distance;
          best = {at->edge, at->point};
        }
      }
    }
    return best;
  }

 private:
  using Key = std::pair<int, int>;
  struct Entry {
    Key key;
    std::size_t edge;
    std::size_t point;
    auto operator<=>(const Entry&) const = default;
  };
  Key key(vec2 p) const { return {static_cast<int>(std::floor(p.x / side_)), static_cast<int>(std::floor(p.y / side_))}; }
  double side_;
  std::vector<Entry> points_;
};

void land_free_ends(LineGraph& graph, double short_px) {
  // Edges are split as ends land, so each end looks anew; there are few of them.
  PointGrid grid(graph, short_px);
  for (const FreeEnd& end : free_ends(graph)) {
    if (graph.nodes()[end.node].edges.size() != 1) continue;
    const std::size_t own = graph.nodes()[end.node].edges.front();
    const Landing landing = grid.landing(graph, end, short_px, own);
    if (landing.edge == none || !graph.edges()[landing.edge].alive) continue;
    const GraphEdge& met = graph.edges()[landing.edge];
    std::size_t node = none;
    if (landing.point == 0) {
      node = met.from;
    } else if (landing.point + 1 == met.points.size()) {
      node = met.to;
    } else {
      node = graph.split(landing.edge, landing.point);
    }
    if (node != end.node) graph.add_edge(end.node, node, {end.at, graph.nodes()[node].at});
  }
}

}  // namespace

void bridge_gaps(LineGraph& graph, double gap_px, double turn_deg, double short_px) {
  const double least_cosine = Angle::degrees(turn_deg).direction().x;
  const std::vector<FreeEnd> ends = free_ends(graph);
  std::vector<bool> taken(ends.size(), false);
  for (const Bridge& bridge : bridges(ends, gap_px, least_cosine)) {
    if (taken[bridge.one] || taken[bridge.two]) continue;
    taken[bridge.one] = true;
    taken[bridge.two] = true;
    graph.add_edge(ends[bridge.one].node, ends[bridge.two].node, {ends[bridge.one].at, ends[bridge.two].at});
  }
  graph.join_passed_nodes();
  land_free_ends(graph, short_px);
  graph.join_passed_nodes();
}

}  // namespace shatterpave::trace
