#include "geometry/clip.h"

#include <gtest/gtest.h>

namespace shatterpave::geometry {
namespace {

Polygon square(double x, double y, double size) { return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}; }

TEST(Clip, IntersectionLeavesOutHoles) {
  const Region ring{square(0, 0, 10), {square(4, 4, 2)}};
  const auto parts = intersection(square(3, 3, 4), ring);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(area(parts.front()), 12.0);
  ASSERT_EQ(parts.front().holes.size(), 1U);
  EXPECT_GT(area(parts.front().outline), 0.0);
  EXPECT_LT(area(parts.front().holes.front()), 0.0);
}

TEST(Clip, EitherWindingMeansTheSame) {
  const Polygon clockwise{{0, 0}, {0, 10}, {10, 10}, {10, 0}};
  const auto parts = intersection(clockwise, {square(5, 5, 10), {}});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(area(parts.front()), 25.0);
}

TEST(Clip, UnionOfNeighboursHasNoVertexLeftBetweenThem) {
  const auto parts = united({square(0, 0, 10), square(10, 0, 10)});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts.front().outline.size(), 4U);
  EXPECT_EQ(area(parts.front()), 200.0);
}

TEST(Clip, DifferenceCanFallApart) {
  const auto parts = difference({square(0, 0, 10), {}}, {{{4, -1}, {6, -1}, {6, 11}, {4, 11}}});
  EXPECT_EQ(parts.size(), 2U);
}

TEST(Clip, OffsetMovesSidesAndMitresCorners) {
  const auto smaller = offset({square(0, 0, 10), {}}, -1.0);
  ASSERT_EQ(smaller.size(), 1U);
  EXPECT_EQ(area(smaller.front()), 64.0);
  const auto larger = offset({square(0, 0, 10), {square(4, 4, 2)}}, 0.5);
  ASSERT_EQ(larger.size(), 1U);
  EXPECT_EQ(area(larger.front()), 121.0 - 1.0);
  EXPECT_TRUE(offset({square(0, 0, 10), {}}, -5.1).empty());
}

TEST(Clip, CleanedDropsWhatAddsNothing) {
  const Polygon messy{{0, 0}, {5, 0}, {5, 0}, {10, 0}, {10, 10}, {10, 15}, {10, 10}, {0, 10}, {0, 5}};
  EXPECT_EQ(cleaned(messy).size(), 4U);
  EXPECT_EQ(area(cleaned(messy)), 100.0);
  EXPECT_TRUE(cleaned({{0, 0}, {5, 0}, {10, 0}}).empty());
  EXPECT_TRUE(cleaned({{0, 0}, {0.0002, 0.0001}, {0, 0.0003}}).empty());
}

TEST(Clip, SimpleIsTold) {
  EXPECT_TRUE(is_simple(square(0, 0, 1)));
  EXPECT_FALSE(is_simple({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));          // crosses itself
  EXPECT_FALSE(is_simple({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));  // touches its own side
  EXPECT_FALSE(is_simple({{0, 0}, {2, 0}, {1, 0}, {1, 2}}));          // doubles back
  EXPECT_FALSE(is_simple({{0, 0}, {1, 0}}));
}

}  // namespace
}  // namespace shatterpave::geometry
