#include "geometry/segment_distance.h"

#include <gtest/gtest.h>

#include "geometry/corners.h"

namespace shatterpave::geometry {
namespace {

TEST(SegmentDistance, IsToTheFootOrToTheNearerEnd) {
  EXPECT_EQ(nearest_on_segment({3, 5}, {0, 0}, {10, 0}), (vec2{3, 0}));
  EXPECT_EQ(distance_to_segment({3, 5}, {0, 0}, {10, 0}), 5.0);
  EXPECT_EQ(distance_to_segment({-3, 4}, {0, 0}, {10, 0}), 5.0);
  EXPECT_EQ(distance_to_segment({13, -4}, {0, 0}, {10, 0}), 5.0);
  EXPECT_EQ(distance_to_segment({7, 0}, {0, 0}, {10, 0}), 0.0);
  // A segment that is a point.
  EXPECT_EQ(nearest_on_segment({7, 1}, {4, 5}, {4, 5}), (vec2{4, 5}));
  EXPECT_EQ(distance_to_segment({7, 1}, {4, 5}, {4, 5}), 5.0);
}

TEST(Corners, RunCounterClockwiseFromTheLowerLeft) {
  const Box box{{1, 2}, {4, 7}};
  EXPECT_EQ(corners(box), (std::array<vec2, 4>{vec2{1, 2}, vec2{4, 2}, vec2{4, 7}, vec2{1, 7}}));
  EXPECT_EQ(rectangle(box), (Polygon{{1, 2}, {4, 2}, {4, 7}, {1, 7}}));
  EXPECT_EQ(area(rectangle(box)), 15.0);
}

}  // namespace
}  // namespace shatterpave::geometry
