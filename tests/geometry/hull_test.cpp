#include "geometry/hull.h"

#include <gtest/gtest.h>

namespace shatterpave::geometry {
namespace {

TEST(ConvexHull, IsTheSmallestConvexPolygon) {
  const Polygon notched{{0, 0}, {2, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 3}};
  const Polygon hull = convex_hull(notched);
  EXPECT_EQ(hull.size(), 4U);
  EXPECT_EQ(area(hull), 12.0);
  EXPECT_EQ(area(notched), 8.0);
}

TEST(ConvexHull, LeavesConvexPolygonsAsTheyAre) {
  const Polygon triangle{{0, 0}, {5, 1}, {2, 4}};
  EXPECT_EQ(convex_hull(triangle).size(), 3U);
  EXPECT_EQ(area(convex_hull(triangle)), area(triangle));
}

}  // namespace
}  // namespace shatterpave::geometry
