#include "glass/map/contact_graph.h"

#include <gtest/gtest.h>

namespace shatterpave::glass {
namespace {

TEST(ContactGraph, KnowsWhatIsConnected) {
  ContactGraph graph;
  for (int i = 0; i < 6; ++i) EXPECT_EQ(graph.add(), i);
  graph.connect(0, 1, {1, 0});
  graph.connect(2, 3, {2, 0});
  EXPECT_TRUE(graph.connected(0, 1));
  EXPECT_FALSE(graph.connected(1, 2));
  graph.connect(1, 3, {3, 0});
  EXPECT_TRUE(graph.connected(0, 2));
  EXPECT_FALSE(graph.connected(0, 4));
}

TEST(ContactGraph, FindsAShortestWayAndWhereEachNodeIsEntered) {
  ContactGraph graph;
  for (int i = 0; i < 7; ++i) graph.add();
  for (int i = 0; i < 5; ++i) graph.connect(i, i + 1, {i, 10});
  graph.connect(0, 6, {60, 0});
  graph.connect(6, 4, {64, 0});
  using Way = std::vector<ContactGraph::Contact>;
  EXPECT_EQ(graph.way(0, 1), (Way{{1, {0, 10}}}));
  EXPECT_EQ(graph.way(0, 4), (Way{{6, {60, 0}}, {4, {64, 0}}}));
  EXPECT_EQ(graph.way(0, 5), (Way{{6, {60, 0}}, {4, {64, 0}}, {5, {4, 10}}}));
  EXPECT_EQ(graph.way(5, 3), (Way{{4, {4, 10}}, {3, {3, 10}}}));
}

}  // namespace
}  // namespace shatterpave::glass
