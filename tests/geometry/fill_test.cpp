#include "geometry/fill.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/lattice.h"
#include "geometry/predicates.h"
#include "geometry/simple.h"

namespace shatterpave::geometry {
namespace {

Polygon square_ring(double x, double y, double size) { return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}; }
Polygon backwards(Polygon ring) {
  std::ranges::reverse(ring);
  return ring;
}
double total_area(const std::vector<Region>& regions) {
  double sum = 0.0;
  for (const Region& region : regions) sum += area(region);
  return sum;
}

TEST(Fill, FollowsTheRules) {
  EXPECT_EQ(total_area(filled({square_ring(0, 0, 10), square_ring(5, 0, 10)}, FillRule::nonzero)), 150.0);
  EXPECT_EQ(total_area(filled({square_ring(0, 0, 10), square_ring(5, 0, 10)}, FillRule::evenodd)), 100.0);
  EXPECT_EQ(total_area(filled({square_ring(0, 0, 10), backwards(square_ring(5, 0, 10))}, FillRule::nonzero)), 100.0);
  // Twice the same, and the same there and back.
  EXPECT_EQ(total_area(filled({square_ring(0, 0, 10), square_ring(0, 0, 10)}, FillRule::nonzero)), 100.0);
  EXPECT_TRUE(filled({square_ring(0, 0, 10), square_ring(0, 0, 10)}, FillRule::evenodd).empty());
  EXPECT_TRUE(filled({square_ring(0, 0, 10), backwards(square_ring(0, 0, 10))}, FillRule::nonzero).empty());
  EXPECT_TRUE(filled({}, FillRule::nonzero).empty());
}

TEST(Fill, PinchedRingsSpikesAndKeyholes) {
  // A bow tie is two areas that touch.
  EXPECT_EQ(filled({{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}, FillRule::evenodd).size(), 2U);
  // A ring that comes back to its side from within has a hole there.
  const auto pinched = filled({{{0, 0}, {8, 0}, {8, 6}, {0, 6}, {0, 3}, {3, 4}, {3, 2}, {0, 3}}}, FillRule::evenodd);
  ASSERT_EQ(pinched.size(), 1U);
  EXPECT_EQ(pinched[0].holes.size(), 1U);
  EXPECT_EQ(area(pinched[0]), 45.0);
  // A spike inwards is no cut.
  EXPECT_EQ(filled({{{0, 0}, {10, 0}, {10, 10}, {5, 10}, {5, 3}, {5, 10}, {0, 10}}}, FillRule::evenodd),
            filled({square_ring(0, 0, 10)}, FillRule::evenodd));
  // A keyhole: out along a bridge to a hole, and back along it.
  const auto keyhole =
      filled({{{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 6}, {6, 6}, {6, 4}, {5, 4}, {5, 0}, {10, 0}, {10, 10}, {0, 10}}},
             FillRule::nonzero);
  ASSERT_EQ(keyhole.size(), 1U);
  EXPECT_EQ(keyhole[0].outline, square_ring(0, 0, 10));
  EXPECT_EQ(keyhole[0].holes.size(), 1U);
}

TEST(Fill, SidesThatMissEachOtherByAMicrometreAreSnapped) {
  // The right side of the left one has a vertex 1 µm beyond the straight side of the right one.
  const auto joined =
      filled({{{0, 0}, {10, 0}, {10.001, 5}, {10, 10}, {0, 10}}, {{10, 0}, {20, 0}, {20, 10}, {10, 10}}}, FillRule::nonzero);
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_NEAR(area(joined[0]), 200.0, 0.01);
  EXPECT_TRUE(joined[0].holes.empty());
}

TEST(Fill, WithoutHolesThatLieAnyhow) {
  const Polygon outline = square_ring(0, 0, 10);
  const auto left = [&](const std::vector<Polygon>& holes) {
    return total_area(filled_without(outline, holes, FillRule::evenodd));
  };
  EXPECT_EQ(left({square_ring(0, 2, 2)}), 96.0);                        // along the outline
  EXPECT_EQ(left({square_ring(9, 2, 2)}), 98.0);                        // across it
  EXPECT_EQ(left({square_ring(2, 2, 2), square_ring(3, 2, 2)}), 94.0);  // across each other
  EXPECT_EQ(left({square_ring(2, 2, 2), backwards(square_ring(2, 2, 2))}), 96.0);
  EXPECT_EQ(left({square_ring(20, 2, 2), square_ring(2, 2, 4), square_ring(3, 3, 1)}), 84.0);  // outside; one in another
  EXPECT_EQ(left({square_ring(-1, -1, 12)}), 0.0);
  EXPECT_EQ(filled_without(outline, {{{4, -1}, {6, -1}, {6, 11}, {4, 11}}}, FillRule::evenodd).size(), 2U);
}

TEST(Fill, FaultlessRegionsStayAsTheyAre) {
  const std::vector<Region> sound = {{{{5, 5}, {0, 5}, {0, 0}, {5, 0}}, {}}};
  EXPECT_EQ(without_faults(sound), sound);
  const auto mended = without_faults({{square_ring(0, 0, 10), {backwards(square_ring(0, 2, 2))}}});
  ASSERT_EQ(mended.size(), 1U);
  EXPECT_EQ(area(mended[0]), 96.0);
}

TEST(Fill, RefusesEndlessCrossings) {
  Polygon comb;
  for (int i = 0; i < 1500; ++i) comb.push_back({i % 2 == 0 ? 0.0 : 9000.0, i * 1.0});
  for (int i = 0; i < 1500; ++i) comb.push_back({3.0 * i, i % 2 == 0 ? -10.0 : 9000.0});
  EXPECT_THROW(filled({comb}, FillRule::evenodd), TooManyCrossings);
}

int winding(const Polygon& ring, vec2 at) {
  const LatticePoint p = to_lattice(at);
  int turns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LatticePoint a = to_lattice(ring[i]);
    const LatticePoint b = to_lattice(ring[(i + 1) % ring.size()]);
    if (a.y <= p.y && b.y > p.y && side(a, b, p) == Side::left) ++turns;
    if (b.y <= p.y && a.y > p.y && side(a, b, p) == Side::right) --turns;
  }
  return turns;
}
double distance_to(const Polygon& ring, vec2 p) {
  double nearest = 1e9;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const vec2 a = ring[i];
    const vec2 along = ring[(i + 1) % ring.size()] - a;
    const double length_2 = glm::dot(along, along);
    const double t = length_2 > 0.0 ? std::clamp(glm::dot(p - a, along) / length_2, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, glm::distance(p, a + t * along));
  }
  return nearest;
}

// Whatever the rings: regions without a fault that hold the points that the winding numbers say. On a coarse lattice almost
// every crossing has to be rounded and every third side runs through a vertex.
RC_GTEST_PROP(Fill, IsWhatWindingNumbersSay, ()) {
  const auto size = *rc::gen::element<std::int64_t>(6, 20, 100, 10'000, 1'000'000'000);
  const auto coordinate = rc::gen::resize(100, rc::gen::inRange<std::int64_t>(0, size));
  const auto point = rc::gen::map(rc::gen::pair(coordinate, coordinate), [](const auto& p) {
    return to_mm(LatticePoint{p.first, p.second});
  });
  std::vector<Polygon> rings;
  const int count = *rc::gen::inRange(1, 4);
  rings.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    rings.push_back(*rc::gen::container<Polygon>(*rc::gen::inRange<std::size_t>(0, 14), point));
  }
  for (const FillRule rule : {FillRule::nonzero, FillRule::evenodd}) {
    const auto regions = filled(rings, rule);
    for (const Region& region : regions) RC_ASSERT(!region_fault(region.outline, region.holes));
    for (int i = 0; i < 20; ++i) {
      const vec2 p = *point;
      int turns = 0;
      double margin = 1e9;
      for (const Polygon& ring : rings) {
        turns += winding(ring, p);
        margin = std::min(margin, distance_to(ring, p));
      }
      if (margin < 3.0 / lattice_per_mm) continue;
      const bool expected = rule == FillRule::nonzero ? turns != 0 : turns % 2 != 0;
      RC_ASSERT(std::ranges::any_of(regions, [&](const Region& region) { return contains(region, p); }) == expected);
    }
  }
}

}  // namespace
}  // namespace shatterpave::geometry
