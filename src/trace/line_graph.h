// Lines of a picture as a graph: where they end and meet, and the ways between.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "trace/picture.h"

namespace shatterpave::trace {

// The number that no node and no edge has.
inline constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

// A way between two nodes.
struct GraphEdge {
  std::size_t from = 0;
  std::size_t to = 0;
  std::vector<vec2> points;  // from the place of `from` to that of `to`, px
  bool alive = true;

  double length() const;
  std::size_t other(std::size_t node) const { return node == from ? to : from; }
};

struct GraphNode {
  vec2 at{0.0, 0.0};
  std::vector<std::size_t> edges;  // alive ones; one that begins and ends here stands twice
};

class LineGraph {
 public:
  // Of a skeleton: pixels with one neighbour, or with three and more, are nodes; those of the latter that touch are one.
  explicit LineGraph(const Mask& skeleton);

  const std::vector<GraphNode>& nodes() const { return nodes_; }
  const std::vector<GraphEdge>& edges() const { return edges_; }

  std::size_t add_node(vec2 at);
  void move_node(std::size_t node, vec2 at);
  void add_edge(std::size_t from, std::size_t to, std::vector<vec2> points);
  void remove(std::size_t edge);
  void set_points(std::size_t edge, std::vector<vec2> points);
  // Makes a node at point `index` of the edge, inside it, which becomes two.
  std::size_t split(std::size_t edge, std::size_t index);
  // Makes one edge of two that meet in a node where no other does.
  void join_passed_nodes();

  // The direction in which the edge leaves the node, over `reach` px of it.
  vec2 direction_from(std::size_t edge, std::size_t node, bool at_end, double reach) const;

 private:
  std::vector<GraphNode> nodes_;
  std::vector<GraphEdge> edges_;
};

// Takes off edges that end free and are no longer than `least_px`, beside others: they come of the rough border of a figure.
void take_off_spurs(LineGraph& graph, double least_px);
// Takes off whatever hangs together and is shorter than `least_px` in all.
void take_off_crumbs(LineGraph& graph, double least_px);
// Makes one edge of two that join the same two nodes and are nowhere farther apart than `apart_px`: traces of one crack on the
// two faces of the pane.
void join_double_lines(LineGraph& graph, double apart_px);
// Bridges gaps of up to `gap_px` between free ends that look at each other, within `turn_deg` of straight on, the nearest
// first; and lets a free end go on to a line that it nearly reaches, within `short_px`.
void bridge_gaps(LineGraph& graph, double gap_px, double turn_deg, double short_px);

double length_of(const std::vector<vec2>& points);

}  // namespace shatterpave::trace
