#include "geometry/planar_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace shatterpave::geometry {
namespace {

// The segments of polylines.
std::vector<Segment> segments_of(const std::vector<std::vector<LatticePoint>>& polylines) {
  std::vector<Segment> segments;
  for (std::size_t owner = 0; owner < polylines.size(); ++owner) {
    const auto& line = polylines[owner];
    for (std::size_t i = 1; i < line.size(); ++i) segments.push_back({line[i - 1], line[i], static_cast<int>(owner)});
  }
  return segments;
}

std::vector<std::int64_t> sorted_areas(const std::vector<Face>& faces) {
  std::vector<std::int64_t> areas(faces.size());
  std::ranges::transform(faces, areas.begin(), [](const Face& face) { return doubled_area(face); });
  std::ranges::sort(areas);
  return areas;
}

const std::vector<LatticePoint> square_loop = {{0, 0}, {50, 0}, {100, 0}, {100, 100}, {50, 100}, {0, 100}, {0, 0}};

TEST(PlanarMap, PartsASquareByACrackAndKeepsWhatEndsInsideAsSpurs) {
  const std::vector<Segment> segments =
      segments_of({square_loop, {{50, 0}, {40, 30}, {50, 100}}, {{40, 30}, {20, 30}, {10, 10}}});
  const std::vector<Face> found = faces(segments);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(sorted_areas(found), (std::vector<std::int64_t>{9000, 11000}));
  const auto left = std::ranges::find_if(found, [](const Face& face) { return !face.spurs.empty(); });
  ASSERT_NE(left, found.end());
  EXPECT_EQ(doubled_area(*left), 9000);
  ASSERT_EQ(left->spurs.size(), 2U);
  for (const std::size_t spur : left->spurs) EXPECT_EQ(segments[spur].owner, 2);
}

// A loop in the middle with an arm into it, one out of it, and a crack alone: hole, face, and spurs of the right one.
TEST(PlanarMap, FindsHolesAndWhatFloatsInThem) {
  const std::vector<Segment> segments = segments_of({square_loop,
                                                     {{30, 30}, {60, 30}, {60, 60}, {30, 60}, {30, 30}},
                                                     {{30, 30}, {40, 40}},
                                                     {{60, 60}, {70, 70}},
                                                     {{45, 50}, {50, 50}},
                                                     {{80, 80}, {90, 90}}});
  const std::vector<Face> found = faces(segments);
  EXPECT_EQ(sorted_areas(found), (std::vector<std::int64_t>{1800, 18200}));
  for (const Face& face : found) {
    const bool outer = doubled_area(face) == 18200;
    EXPECT_EQ(face.holes.size(), outer ? 1U : 0U);
    std::vector<int> spurs;
    for (const std::size_t spur : face.spurs) spurs.push_back(segments[spur].owner);
    std::ranges::sort(spurs);
    EXPECT_EQ(spurs, outer ? (std::vector<int>{3, 5}) : (std::vector<int>{2, 4}));
  }
}

// A bridge leads to a loop: with the bridge on both sides the face would not be a region.
TEST(PlanarMap, CutsBridgesToHoles) {
  const std::vector<Face> found = faces(segments_of({square_loop, {{50, 0}, {50, 30}, {40, 50}, {60, 50}, {50, 30}}}));
  EXPECT_EQ(sorted_areas(found), (std::vector<std::int64_t>{400, 19600}));
  for (const Face& face : found) EXPECT_EQ(face.spurs.size(), face.holes.size());
}

// A loop that touches the border in one point, which the walk about the face comes to twice.
TEST(PlanarMap, PartsRingsThatTouchInAPoint) {
  const std::vector<Face> found = faces(segments_of({square_loop, {{50, 0}, {60, 20}, {40, 20}, {50, 0}}}));
  EXPECT_EQ(sorted_areas(found), (std::vector<std::int64_t>{400, 19600}));
  for (const Face& face : found) {
    std::vector<LatticePoint> vertices;
    for (const FaceSide& side : face.outline) vertices.push_back(side.from);
    std::ranges::sort(vertices);
    EXPECT_EQ(std::ranges::adjacent_find(vertices), vertices.end());
  }
}

TEST(PlanarMap, HasNoFaceWhereNothingIsClosed) {
  EXPECT_TRUE(faces(segments_of({{{0, 0}, {100, 0}, {100, 100}, {0, 1}}, {{200, 0}, {300, 5}}})).empty());
}

}  // namespace
}  // namespace shatterpave::geometry
