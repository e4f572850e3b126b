#include <gtest/gtest.h>

#include <algorithm>

#include "trace/drawing.h"
#include "trace/line_graph.h"
#include "trace/line_mask.h"
#include "trace/skeleton.h"
#include "trace/two_point.h"

namespace shatterpave {
namespace {

using test::DrawnLine;
using trace::LineGraph;

constexpr int patch_px = 200;

LineGraph graph_of(const std::vector<DrawnLine>& lines) {
  const trace::Grey picture = test::drawn(patch_px, patch_px, lines, 30.0, 30.0);
  LineGraph graph(trace::skeleton(trace::threshold_mask(picture, 80)));
  graph.join_passed_nodes();
  trace::take_off_spurs(graph, 4.0);
  return graph;
}

// Of nodes where so many edges meet.
int nodes_with(const LineGraph& graph, std::size_t edges) {
  return static_cast<int>(std::ranges::count_if(graph.nodes(), [&](const auto& node) { return node.edges.size() == edges; }));
}

TEST(LineGraph, KeepsJunctionsOfThreeAndFour) {
  const LineGraph t = graph_of({{{{20, 100}, {180, 100}}}, {{{100, 100}, {100, 180}}}});
  EXPECT_EQ(nodes_with(t, 3), 1);
  EXPECT_EQ(nodes_with(t, 1), 3);
  const LineGraph y = graph_of({{{{100, 20}, {100, 100}}}, {{{100, 100}, {40, 180}}}, {{{100, 100}, {160, 180}}}});
  EXPECT_EQ(nodes_with(y, 3), 1);
  EXPECT_EQ(nodes_with(y, 1), 3);
  const LineGraph plus = graph_of({{{{20, 100}, {180, 100}}}, {{{100, 20}, {100, 180}}}});
  EXPECT_EQ(nodes_with(plus, 4), 1);
  EXPECT_EQ(nodes_with(plus, 1), 4);
}

TEST(LineGraph, BridgesAGapStraightOnAndNoOther) {
  LineGraph straight = graph_of({{{{20, 100}, {90, 100}}}, {{{105, 100}, {180, 100}}}});
  trace::bridge_gaps(straight, 20.0, 25.0, 4.0);
  EXPECT_EQ(nodes_with(straight, 1), 2);
  LineGraph beside = graph_of({{{{20, 100}, {90, 100}}}, {{{105, 112}, {180, 180}}}});
  trace::bridge_gaps(beside, 20.0, 25.0, 4.0);
  EXPECT_EQ(nodes_with(beside, 1), 4);
}

TEST(LineGraph, JoinsTheTwoTracesOfACrack) {
  LineGraph graph = graph_of({{{{20, 100}, {60, 100}}},
                              {{{60, 100}, {80, 96}, {120, 96}, {140, 100}}},
                              {{{60, 100}, {80, 104}, {120, 104}, {140, 100}}},
                              {{{140, 100}, {180, 100}}}});
  trace::join_double_lines(graph, 12.0);
  int alive = 0;
  for (const auto& edge : graph.edges()) {
    if (!edge.alive) continue;
    ++alive;
    for (const vec2 p : edge.points) EXPECT_NEAR(p.y, 100.0, 2.5);
  }
  EXPECT_EQ(alive, 1);
  LineGraph apart = graph_of({{{{60, 100}, {80, 80}, {120, 80}, {140, 100}}},
                              {{{60, 100}, {80, 120}, {120, 120}, {140, 100}}},
                              {{{20, 100}, {60, 100}}},
                              {{{140, 100}, {180, 100}}}});
  trace::join_double_lines(apart, 12.0);
  EXPECT_EQ(nodes_with(apart, 3), 2);
}

// The midpoints of L and R lie in the middle of a ribbon, wherever in it the line that is followed lies.
TEST(TwoPoint, FeaturePointsLieBetweenBothSides) {
  const trace::Grey picture = test::drawn(patch_px, patch_px, {{{{0, 100}, {200, 100}}, 9.0}}, 30.0, 30.0);
  const trace::Mask mask = trace::threshold_mask(picture, 80);
  std::vector<vec2> line;
  for (int x = 10; x <= 190; ++x) line.push_back({x + 0.0, 98.0});
  const std::vector<vec2> points = trace::feature_points(mask, line, 10.0, 15.0);
  ASSERT_EQ(points.size(), 19U);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    EXPECT_NEAR(points[i].y, 100.0, 0.6);
    EXPECT_NEAR(points[i].x - points[i - 1].x, 10.0, 1e-9);
  }
}

}  // namespace
}  // namespace shatterpave
