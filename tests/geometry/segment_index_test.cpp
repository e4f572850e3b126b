#include "geometry/segment_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "core/random.h"
#include "geometry/cell_grid.h"
#include "geometry/point_index.h"
#include "geometry/predicates.h"

namespace shatterpave::geometry {
namespace {

// A number within ±`reach` that the address decides.
double number(std::string_view what, std::uint32_t draw, double reach) {
  return reach * (2.0 * uniform(5, {Stream::turn, Id(what), draw}) - 1.0);
}

vec2 point(std::string_view what, std::uint32_t draw, double reach) {
  return {number(what, 2 * draw, reach), number(what, 2 * draw + 1, reach)};
}

std::vector<Segment> random_segments(int count) {
  std::vector<Segment> segments;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
    const vec2 a = point("place", i, 50.0);
    // Most are short, some cross many cells.
    const vec2 b = a + point("way", i, i % 10 == 0 ? 60.0 : 4.0);
    segments.push_back({to_lattice(a), to_lattice(b), static_cast<int>(i % 7)});
  }
  return segments;
}

Sector random_sector(std::uint32_t draw) {
  const SectorShape shape(Angle::degrees(100.0 + number("opening", draw, 79.0)), 15.0 + number("radius", draw, 14.0));
  return {point("apex", draw, 60.0), Angle::radians(number("axis", draw, pi)).direction(), shape};
}

TEST(SegmentIndex, VisitsEverySegmentThatMeetsAnother) {
  const std::vector<Segment> segments = random_segments(300);
  SegmentIndex index(3.0);
  for (const Segment& segment : segments) index.add(segment);
  int meetings = 0;
  for (const Segment& probe : segments) {
    std::set<int> visited;
    index.visit_near(probe.a, probe.b, [&](int n) { visited.insert(n); });
    for (int n = 0; n < 300; ++n) {
      const Segment& other = segments[static_cast<std::size_t>(n)];
      if (!segments_meet(probe.a, probe.b, other.a, other.b)) continue;
      ++meetings;
      EXPECT_TRUE(visited.contains(n));
    }
    EXPECT_LT(visited.size(), 200U) << "looks nearly everywhere";
  }
  EXPECT_GT(meetings, 300 + 100);  // each meets itself
}

TEST(SegmentIndex, ListsEverySegmentThatReachesIntoABox) {
  const std::vector<Segment> segments = random_segments(300);
  SegmentIndex index(3.0);
  for (const Segment& segment : segments) index.add(segment);
  for (std::uint32_t draw = 0; draw < 100; ++draw) {
    const LatticePoint p = to_lattice(point("corner", draw, 40.0));
    const LatticePoint q = to_lattice(to_mm(p) + point("size", draw, 15.0));
    const std::vector<int> listed = index.near(p, q);
    EXPECT_TRUE(std::ranges::is_sorted(listed));
    for (int n = 0; n < 300; ++n) {
      const Segment& segment = segments[static_cast<std::size_t>(n)];
      const auto ends_inside = [&](LatticePoint end) {
        return std::min(p.x, q.x) <= end.x && end.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= end.y &&
               end.y <= std::max(p.y, q.y);
      };
      if (!ends_inside(segment.a) && !ends_inside(segment.b) && !segments_meet(segment.a, segment.b, p, q)) continue;
      EXPECT_TRUE(std::ranges::binary_search(listed, n));
    }
  }
}

TEST(SegmentIndex, ForgetsWhatIsRemoved) {
  SegmentIndex index(1.0);
  const Segment segment{{-5000, -3000}, {7000, 4000}, 0};
  const int first = index.add(segment);
  const int second = index.add(segment);
  index.remove(first);
  std::set<int> visited;
  index.visit_near(segment.a, segment.b, [&](int n) { visited.insert(n); });
  EXPECT_EQ(visited, std::set<int>{second});
}

TEST(SegmentIndex, FindsTheNearestInASectorAsAllPairsDo) {
  const std::vector<Segment> segments = random_segments(150);
  SegmentIndex index(4.0);
  for (const Segment& segment : segments) index.add(segment);
  int found = 0;
  for (std::uint32_t draw = 0; draw < 500; ++draw) {
    const Sector sector = random_sector(draw);
    double least = std::numeric_limits<double>::infinity();
    for (const Segment& segment : segments) {
      if (segment.owner == 3) continue;
      const auto nearest = sector.nearest_point(to_mm(segment.a), to_mm(segment.b));
      if (nearest) least = std::min(least, glm::length(*nearest - sector.apex()));
    }
    const auto nearest = index.nearest_in(sector, [](const Segment& segment) { return segment.owner != 3; });
    ASSERT_EQ(nearest.has_value(), least <= sector.radius());
    if (!nearest) continue;
    ++found;
    EXPECT_EQ(nearest->distance_mm, least);
    EXPECT_NE(index.segment(nearest->number).owner, 3);
  }
  EXPECT_GT(found, 150);
  EXPECT_LT(found, 450);
}

TEST(PointIndex, FindsTheNearestInASectorAsAllPairsDo) {
  std::vector<vec2> points;
  // A crowd about the origin, as tips about an impact, and some farther out; the first lies on another.
  for (std::uint32_t i = 0; i < 400; ++i) points.push_back(point("point", i, i % 3 == 0 ? 60.0 : 2.0));
  points[0] = points[1];
  PointIndex index(3.0);
  // Each has moved about before it lies where it does, and some were removed.
  for (int i = 0; i < 400; ++i) {
    index.put(i, point("before", static_cast<std::uint32_t>(i), 40.0));
    index.put(i, points[static_cast<std::size_t>(i)]);
    if (i % 11 == 5) index.remove(i);
  }
  const auto kept = [](int i) { return i % 11 != 5; };
  std::size_t most = 0;
  for (std::uint32_t draw = 0; draw < 500; ++draw) {
    const Sector sector = draw % 2 == 0 ? random_sector(draw)
                                        : Sector(points[draw % 400], Angle::radians(number("axis", draw, pi)).direction(),
                                                 SectorShape(Angle::degrees(100.0), 10.0));
    std::vector<int> expected;
    for (int i = 0; i < 400; ++i) {
      const vec2 p = points[static_cast<std::size_t>(i)];
      if (kept(i) && p != sector.apex() && sector.contains(p)) expected.push_back(i);
    }
    std::ranges::stable_sort(expected, {}, [&](int i) {
      const vec2 offset = points[static_cast<std::size_t>(i)] - sector.apex();
      return glm::dot(offset, offset);
    });
    expected.resize(std::min<std::size_t>(expected.size(), 8));
    std::array<PointIndex::Found, 8> found;
    std::vector<int> numbers(index.nearest_in(sector, found));
    std::transform(found.begin(), found.begin() + std::ssize(numbers), numbers.begin(), [](const auto& f) { return f.number; });
    EXPECT_EQ(numbers, expected);
    most = std::max(most, expected.size());
  }
  EXPECT_EQ(most, 8U);
}

// Against a map of all numbers by their cells, about the origin, where columns and rows change their sign.
TEST(CellGrid, HoldsWhatWasAddedAndNotRemoved) {
  CellGrid grid;
  std::map<std::pair<std::int64_t, std::int64_t>, std::multiset<int>> expected;
  const auto cell = [](std::uint32_t draw) {
    return std::pair{std::llround(number("column", draw, 20.0)), std::llround(number("row", draw, 20.0))};
  };
  for (std::uint32_t i = 0; i < 6000; ++i) {
    grid.add(cell(i).first, cell(i).second, static_cast<int>(i));
    expected[cell(i)].insert(static_cast<int>(i));
    if (i < 1000) continue;
    const std::uint32_t gone = i - 1000;  // so that some 1,000 of them, and free places, are always there
    grid.remove(cell(gone).first, cell(gone).second, static_cast<int>(gone));
    expected[cell(gone)].erase(static_cast<int>(gone));
  }
  std::erase_if(expected, [](const auto& entry) { return entry.second.empty(); });
  for (const CellBox& box : {CellBox{-30, -30, 30, 30}, CellBox{-9, -3, 4, 12}, CellBox{2, 2, 5, 5}, CellBox{7, -8, 8, -8}}) {
    std::map<std::pair<std::int64_t, std::int64_t>, std::multiset<int>> found;
    grid.visit_occupied(box, [&](std::int64_t column, std::int64_t row) {
      grid.visit(column, row, [&](int n) { found[{column, row}].insert(n); });
    });
    auto within = expected;
    std::erase_if(within, [&](const auto& entry) {
      const auto [column, row] = entry.first;
      return column < box.first_column || column > box.last_column || row < box.first_row || row > box.last_row;
    });
    EXPECT_EQ(found, within);
    EXPECT_EQ(grid.is_empty(box), within.empty());
  }
  EXPECT_TRUE(grid.is_empty({100, 100, 140, 140}));
}

TEST(Sector, TakesTheNearestPartOfASegmentThatItSees) {
  const Sector sector({0.0, 0.0}, {1.0, 0.0}, SectorShape(Angle::degrees(90.0), 10.0));
  // Straight across: the foot of the perpendicular.
  EXPECT_EQ(sector.nearest_point({4.0, -9.0}, {4.0, 9.0}), vec2(4.0, 0.0));
  // Passing by: the foot lies behind, so the point where it enters the fan.
  const auto entry = sector.nearest_point({-5.0, 3.0}, {9.0, 3.0});
  ASSERT_TRUE(entry.has_value());
  EXPECT_NEAR(glm::length(*entry - vec2(3.0, 3.0)), 0.0, 1e-12);
  // Behind, beside, and too far.
  EXPECT_FALSE(sector.nearest_point({-4.0, -9.0}, {-4.0, 9.0}).has_value());
  EXPECT_FALSE(sector.nearest_point({1.0, 2.0}, {3.0, 9.0}).has_value());
  EXPECT_FALSE(sector.nearest_point({10.5, -1.0}, {10.5, 1.0}).has_value());
}

TEST(Sector, BoundsHoldWhatItContains) {
  int contained = 0;
  for (std::uint32_t draw = 0; draw < 300; ++draw) {
    const Sector sector = random_sector(draw);
    const double reach = 0.6 * sector.radius();
    const auto [low, high] = sector.bounds(reach);
    for (std::uint32_t k = 0; k < 30; ++k) {
      const vec2 p = sector.apex() + point("probe", 30 * draw + k, reach);
      if (!sector.contains(p) || glm::length(p - sector.apex()) > reach) continue;
      ++contained;
      EXPECT_TRUE(glm::all(glm::lessThanEqual(low, p)) && glm::all(glm::lessThanEqual(p, high)));
      EXPECT_TRUE(sector.may_meet(p - 0.1, p + 0.1, reach));
    }
    EXPECT_FALSE(sector.may_meet(sector.apex() + reach, sector.apex() + 2.0 * reach, reach));
  }
  EXPECT_GT(contained, 1000);
}

}  // namespace
}  // namespace shatterpave::geometry
