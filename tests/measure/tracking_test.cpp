#include "measure/tracking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.h"

namespace shatterpave::measure {
namespace {

TEST(Tracked, StepsAlongStraightLinesOfAnyLength) {
  // One segment of three and a half steps, and the same line in short pieces.
  const std::vector<vec2> expected = {{1.0, 2.0}, {3.0, 2.0}, {5.0, 2.0}, {7.0, 2.0}};
  EXPECT_EQ(tracked(std::vector<vec2>{{1.0, 2.0}, {8.0, 2.0}}, 2.0), expected);
  EXPECT_EQ(tracked(std::vector<vec2>{{1.0, 2.0}, {1.5, 2.0}, {4.0, 2.0}, {5.0, 2.0}, {8.0, 2.0}}, 2.0), expected);
  // The last point counts where it is a whole step away; a line shorter than a step has its first point only.
  EXPECT_EQ(tracked(std::vector<vec2>{{1.0, 2.0}, {7.0, 2.0}}, 2.0), expected);
  EXPECT_EQ(tracked(std::vector<vec2>{{1.0, 2.0}, {2.9, 2.0}}, 2.0), (std::vector<vec2>{{1.0, 2.0}}));
}

// Round a corner the step is taken as the crow flies: (0, 0) → (0.6, 0) on the first leg, then up to distance 1.
TEST(Tracked, CutsCorners) {
  const std::vector<vec2> points = tracked(std::vector<vec2>{{0.0, 0.0}, {0.6, 0.0}, {0.6, 3.0}}, 1.0);
  ASSERT_EQ(points.size(), 4U);
  EXPECT_NEAR(points[1].x, 0.6, 1e-12);
  EXPECT_NEAR(points[1].y, 0.8, 1e-12);
  EXPECT_NEAR(points[2].y, 1.8, 1e-12);
  EXPECT_NEAR(points[3].y, 2.8, 1e-12);
}

TEST(AtWholePixels, MovesEachPointToTheNearest) {
  const vec2 origin{0.1, 0.2};
  const std::vector<vec2> points =
      at_whole_pixels({origin + glass::px_mm * vec2{3.4, -2.6}, origin + glass::px_mm * vec2{0.5, 7.0}}, origin);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(glm::length(points[0] - (origin + glass::px_mm * vec2{3.0, -3.0})), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(points[1] - (origin + glass::px_mm * vec2{1.0, 7.0})), 0.0, 1e-12);
}

TEST(Turns, AreCounterClockwisePositive) {
  const std::vector<Angle> found = turns(std::vector<vec2>{{0.0, 0.0}, {1.0, 0.0}, {2.0, 1.0}, {3.0, 1.0}, {3.0, 0.0}});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_NEAR(found[0].degrees(), 45.0, 1e-12);
  EXPECT_NEAR(found[1].degrees(), -45.0, 1e-12);
  EXPECT_NEAR(found[2].degrees(), -90.0, 1e-12);
  EXPECT_TRUE(turns(std::vector<vec2>{{0.0, 0.0}, {1.0, 0.0}}).empty());
  EXPECT_TRUE(turns(std::vector<vec2>{{0.0, 0.0}}).empty());
}

// A polygon about a circle of radius r: chords of length a turn by 2 asin(a / 2r).
TEST(Turns, OfACircleFollowFromItsRadius) {
  std::vector<vec2> circle;
  for (int i = 0; i <= 3000; ++i) circle.push_back(Angle::degrees(0.1 * i).direction() * 40.0);
  const std::vector<Angle> found = turns(tracked(circle));
  ASSERT_GT(found.size(), 40U);
  for (const Angle turn : found) EXPECT_NEAR(turn.radians(), 2.0 * std::asin(chord_mm / 80.0), 1e-5);
}

// By brute force: from each feature point, a walk in small steps to the first place that is far enough away.
TEST(Tracked, IsTheWalkAlongRandomLines) {
  constexpr double step = 1.7;
  constexpr int parts = 4000;  // of a segment, each of at most 2 µm
  int compared = 0;
  for (std::uint32_t line_index = 0; line_index < 30; ++line_index) {
    const auto draw = [&](std::uint32_t i) { return uniform(1, {Stream::turn, Id("line").child(line_index), i}); };
    std::vector<vec2> line = {{0.0, 0.0}};
    for (std::uint32_t i = 0; i < 12; ++i)
      line.push_back(line.back() + vec2{6.0 * draw(2 * i) - 2.0, 6.0 * draw(2 * i + 1) - 3.0});
    const std::vector<vec2> points = tracked(line, step);
    std::size_t next = 1;
    for (std::size_t i = 1; i < line.size(); ++i) {
      for (int k = 1; k <= parts; ++k) {
        const vec2 p = glm::mix(line[i - 1], line[i], static_cast<double>(k) / parts);
        if (glm::length(p - points[next - 1]) < step) continue;
        ASSERT_LT(next, points.size());
        EXPECT_NEAR(glm::length(points[next] - p), 0.0, 0.01) << line_index << ": " << next;
        ++next;
      }
    }
    EXPECT_EQ(next, points.size());
    compared += static_cast<int>(points.size());
  }
  EXPECT_GT(compared, 300);
}

}  // namespace
}  // namespace shatterpave::measure
