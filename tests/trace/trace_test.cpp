#include <gtest/gtest.h>

#include <string>

#include "core/error.h"
#include "core/parallel.h"
#include "measure/crossings.h"
#include "trace/drawing.h"
#include "trace/trace.h"

namespace shatterpave {
namespace {

using test::DrawnLine;
using test::star;

constexpr int side = 600;

// A star of 24 lines of which 8 reach the border, with a ring between two of them.
std::vector<DrawnLine> pane_lines(vec2 centre, double level) {
  std::vector<DrawnLine> lines = star(centre, 24, 8, side, 120.0, level);
  DrawnLine ring{{}, 2.0, level};
  for (int i = 0; i <= 20; ++i) ring.points.push_back(centre + 170.0 * Angle::degrees(7.0 + 45.0 * i / 20.0).direction());
  lines.push_back(ring);
  return lines;
}

trace::Trace traced_pane(const trace::Grey& picture, trace::Options options = {}) {
  options.pane_mm = vec2{300.0, 300.0};
  return trace::traced(picture, options);
}

void expect_found(const trace::Trace& trace, vec2 centre) {
  const glass::ImpactCounts& counts = trace.network.impacts.front();
  EXPECT_LT(glass::ImpactCounts().radial_count, counts.radial_count);
  EXPECT_NEAR(trace.impact_px.x, centre.x, 3.0);
  EXPECT_NEAR(trace.impact_px.y, centre.y, 3.0);
  EXPECT_EQ(counts.radial_count, 24);
  EXPECT_EQ(counts.large_count, 8);
  double ring_mm = 0.0;
  int rings = 0;
  for (const glass::Crack& crack : trace.network.cracks) {
    if (crack.kind != glass::CrackKind::circular) continue;
    ++rings;
    for (const vec2 p : crack.points_mm) ring_mm = std::max(ring_mm, std::abs(glm::length(p - counts.at_mm) - 85.0));
  }
  EXPECT_EQ(rings, 1);
  EXPECT_LT(ring_mm, 1.7);  // 2 % of the radius
  EXPECT_TRUE(measure::crossings(trace.network).empty());
}

constexpr vec2 centre{310.0, 285.0};

TEST(Trace, FindsAStarOfBrightLines) {
  expect_found(traced_pane(test::drawn(side, side, pane_lines(centre, 120.0), 20.0, 20.0)), centre);
}

TEST(Trace, FindsDarkLinesOnUnevenGround) {
  expect_found(traced_pane(test::drawn(side, side, pane_lines(centre, -70.0), 100.0, 240.0)), centre);
}

TEST(Trace, FindsLinesInNoise) {
  expect_found(traced_pane(test::drawn(side, side, pane_lines(centre, 110.0), 60.0, 60.0, 12.75)), centre);
}

TEST(Trace, FindsAnImpactNearACorner) {
  const vec2 corner{70.0, 520.0};
  const trace::Trace trace = traced_pane(test::drawn(side, side, star(corner, 24, 12, side, 200.0, 120.0), 20.0, 20.0));
  EXPECT_NEAR(trace.impact_px.x, corner.x, 3.0);
  EXPECT_NEAR(trace.impact_px.y, corner.y, 3.0);
}

TEST(Trace, FollowsTheChainOfThePaper) {
  trace::Options options;
  options.chain = trace::Chain::paper;
  options.threshold = 90;
  const trace::Trace trace = traced_pane(test::drawn(side, side, pane_lines(centre, 200.0), 20.0, 20.0), options);
  EXPECT_EQ(trace.network.impacts.front().large_count, 8);
  EXPECT_NEAR(trace.impact_px.x, centre.x, 3.0);
}

// One line fewer is told.
TEST(Trace, TellsALineFewer) {
  std::vector<DrawnLine> lines = pane_lines(centre, 120.0);
  lines.erase(lines.begin() + 1);
  EXPECT_EQ(traced_pane(test::drawn(side, side, lines, 20.0, 20.0)).network.impacts.front().radial_count, 23);
}

// Seen from aside: the corners of the pane in the photograph undo it.
TEST(Trace, SeesThePaneStraight) {
  const trace::Corners corners = {vec2{80.0, 60.0}, vec2{700.0, 120.0}, vec2{690.0, 640.0}, vec2{100.0, 720.0}};
  const trace::Perspective map = trace::perspective_to(corners, side, side);
  std::vector<DrawnLine> lines;
  for (const DrawnLine& line : pane_lines(centre, 120.0)) {
    DrawnLine seen{{}, line.width_px, line.level};
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      for (int k = 0; k <= 20; ++k)
        seen.points.push_back(map(line.points[i - 1] + k / 20.0 * (line.points[i] - line.points[i - 1])));
    }
    lines.push_back(seen);
  }
  trace::Options options;
  options.corners_px = corners;
  const trace::Trace trace = traced_pane(test::drawn(800, 800, lines, 20.0, 20.0), options);
  EXPECT_NEAR(trace.network.impacts.front().at_mm.x, 155.0, 1.5);
  EXPECT_NEAR(trace.network.impacts.front().at_mm.y, 300.0 - 142.5, 1.5);
  EXPECT_NEAR(glm::length(trace.impact_px - map(centre)), 0.0, 3.0);
  EXPECT_EQ(trace.network.impacts.front().large_count, 8);
}

std::string refusal(const trace::Grey& picture) {
  try {
    traced_pane(picture);
  } catch (const InputError& error) {
    return error.message();
  }
  return "none";
}

TEST(Trace, RefusesPicturesWithoutCracks) {
  EXPECT_NE(refusal(trace::Grey(side, side, 128)).find("expected lines"), std::string::npos);
  EXPECT_NE(refusal(test::drawn(side, side, {}, 20.0, 220.0)).find("expected lines"), std::string::npos);
  EXPECT_NE(refusal(test::drawn(side, side, {}, 120.0, 120.0, 12.75)).find("expected"), std::string::npos);
}

TEST(Trace, RefusesABrickWall) {
  std::vector<DrawnLine> lines;
  for (int row = 0; row < 15; ++row) {
    const double y = 20.0 + 40.0 * row;
    lines.push_back({{{0.0, y}, {600.0, y}}, 4.0, 60.0});
    for (int i = 0; i < 8; ++i) {
      const double x = 80.0 * i + (row % 2 == 0 ? 10.0 : 50.0);
      lines.push_back({{{x, y}, {x, y + 40.0}}, 4.0, 60.0});
    }
  }
  EXPECT_NE(refusal(test::drawn(side, side, lines, 110.0, 130.0, 5.0)).find("do not meet in one place"), std::string::npos);
}

TEST(Trace, RefusesCornersInAnotherOrder) {
  trace::Options options;
  options.corners_px = {vec2{10.0, 10.0}, vec2{10.0, 500.0}, vec2{500.0, 500.0}, vec2{500.0, 10.0}};
  EXPECT_THROW(traced_pane(test::drawn(side, side, pane_lines(centre, 120.0), 20.0, 20.0), options), InputError);
}

TEST(Trace, IsTheSameOnAnyNumberOfThreadsParallel) {
  const trace::Grey picture = test::drawn(side, side, pane_lines(centre, 120.0), 20.0, 90.0, 5.0);
  const auto network = [&](int threads) {
    const ThreadLimit limit(threads);
    return traced_pane(picture).network;
  };
  const glass::CrackNetwork one = network(1);
  EXPECT_EQ(one, network(2));
  EXPECT_EQ(one, network(7));
}

}  // namespace
}  // namespace shatterpave
