#include "geometry/simple.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/random.h"
#include "geometry/predicates.h"
#include "support/rings.h"

namespace shatterpave::geometry {
namespace {

using support::reversed;

using Kind = RegionFault::Kind;

const Polygon plain_square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};

struct Case {
  std::string name;
  Polygon outline;
  std::vector<Polygon> holes;
  std::optional<RegionFault> fault;
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for.
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class RegionFaults : public testing::TestWithParam<Case> {};

TEST_P(RegionFaults, AreFoundWhateverTheWinding) {
  const Case& c = GetParam();
  const auto found = region_fault(c.outline, c.holes);
  ASSERT_EQ(found.has_value(), c.fault.has_value());
  std::vector<Polygon> reversed_holes;
  for (const Polygon& hole : c.holes) reversed_holes.push_back(reversed(hole));
  const auto mirrored = region_fault(reversed(c.outline), reversed_holes);
  ASSERT_EQ(mirrored.has_value(), c.fault.has_value());
  if (!c.fault) return;
  EXPECT_EQ(found->kind, c.fault->kind);
  EXPECT_EQ(found->a, c.fault->a);
  EXPECT_EQ(found->b, c.fault->b);
  EXPECT_EQ(found->at_mm, c.fault->at_mm);
  EXPECT_EQ(mirrored->kind, c.fault->kind);
  EXPECT_EQ(mirrored->at_mm, c.fault->at_mm);
}

const std::vector<Case> cases = {
    {"plain_square", plain_square, {}, {}},
    {"bow_tie", {{0, 0}, {10, 10}, {10, 0}, {0, 10}}, {}, RegionFault{Kind::crossing, {0, 0}, {0, 2}, {5, 5}}},
    {"spike", {{0, 0}, {10, 0}, {20, 0}, {10, 0}, {10, 10}}, {}, RegionFault{Kind::touch, {0, 0}, {0, 2}, {10, 0}}},
    {"flat", {{0, 0}, {10, 0}, {5, 0}}, {}, RegionFault{Kind::overlap, {0, 0}, {0, 2}, {0, 0}}},
    {"vertex_on_edge", {{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}}, {}, RegionFault{Kind::touch, {0, 0}, {0, 3}, {5, 0}}},
    {"vertex_on_vertex",
     {{0, 0}, {5, 5}, {10, 0}, {10, 10}, {5, 5}, {0, 10}},
     {},
     RegionFault{Kind::touch, {0, 0}, {0, 3}, {5, 5}}},
    {"collinear_vertices", {{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 5}}, {}, {}},
    {"hole", plain_square, {{{2, 2}, {4, 2}, {4, 4}, {2, 4}}}, {}},
    {"hole_touching_outline", plain_square, {{{0, 5}, {4, 4}, {4, 6}}}, {}},
    {"hole_corner_on_corner", plain_square, {{{0, 0}, {4, 1}, {1, 4}}}, {}},
    {"holes_touching", plain_square, {{{2, 2}, {4, 2}, {4, 4}, {2, 4}}, {{4, 4}, {6, 4}, {6, 6}}}, {}},
    {"hole_across", plain_square, {{{5, 5}, {15, 4}, {15, 6}}}, RegionFault{Kind::crossing, {0, 1}, {1, 0}, {10, 4.5}}},
    {"hole_along_outline", plain_square, {{{2, 0}, {4, 0}, {4, 4}}}, RegionFault{Kind::overlap, {0, 0}, {1, 0}, {2, 0}}},
    {"hole_outside", plain_square, {{{12, 2}, {14, 2}, {14, 4}}}, RegionFault{Kind::hole_outside, {1, 0}, {1, 0}, {12, 2}}},
    {"hole_about_outline",
     plain_square,
     {{{-1, -1}, {20, -1}, {20, 20}, {-1, 20}}},
     RegionFault{Kind::hole_outside, {1, 0}, {1, 0}, {-1, -1}}},
    {"hole_in_hole",
     plain_square,
     {{{1, 1}, {9, 1}, {9, 9}, {1, 9}}, {{3, 3}, {5, 3}, {5, 5}}},
     RegionFault{Kind::holes_overlap, {2, 0}, {2, 0}, {3, 3}}},
    {"same_hole_twice",
     plain_square,
     {{{2, 2}, {4, 2}, {4, 4}}, {{2, 2}, {4, 2}, {4, 4}}},
     RegionFault{Kind::overlap, {1, 0}, {2, 0}, {2, 2}}},
    // No two edges cross here: the hole leaves the outline through its corner.
    {"hole_through_a_corner",
     {{0, 0}, {5, 3}, {10, 0}, {10, 10}, {0, 10}},
     {{{5, 5}, {4, 1}, {5, 3}}},
     RegionFault{Kind::crossing, {0, 0}, {1, 0}, {4.412, 2.647}}},
};

INSTANTIATE_TEST_SUITE_P(Cases, RegionFaults, testing::ValuesIn(cases), [](const auto& test) { return test.param.name; });

// A hole that goes through a vertex of the outline by a vertex of its own: nothing but the sides of the edges tells.
TEST(RegionFault, HolePassingThroughAVertexIsOutside) {
  const Polygon hole = {{8, 4}, {10, 5}, {12, 6}, {10.5, 5.5}, {10, 5.25}, {8, 6}};
  const Polygon outline = {{0, 0}, {10, 0}, {10, 5}, {10, 5.25}, {10, 10}, {0, 10}};
  const auto fault = region_fault(outline, {hole});
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, Kind::hole_outside);
}

// All pairs of edges, straight from the definition.
bool simple_by_brute_force(const Polygon& ring) {
  const std::size_t n = ring.size();
  const auto vertex = [&](std::size_t i) { return to_lattice(ring[i % n]); };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool follows = j == i + 1;
      const bool precedes = (j + 1) % n == i;
      if (!follows && !precedes) {
        if (segments_meet(vertex(i), vertex(i + 1), vertex(j), vertex(j + 1))) return false;
      } else {
        const std::size_t before = follows ? i : j;  // the edge that comes first; the other starts where it ends
        if (on_segment(vertex(before), vertex(before + 1), vertex(before + 2))) return false;
        if (on_segment(vertex(before + 1), vertex(before + 2), vertex(before))) return false;
      }
    }
  }
  return true;
}

TEST(RegionFault, AgreesWithAllPairsOnSmallLattices) {
  int simple = 0;
  int faulty = 0;
  for (std::uint32_t round = 0; round < 60'000; ++round) {
    // Few places, so that vertices coincide, lie on edges and edges overlap all the time.
    const auto draw = [&](std::uint32_t i) { return uniform(1, {Stream::turn, Id("simple").child(round), i}); };
    const std::size_t n = 3 + static_cast<std::size_t>(draw(0) * 6);
    const double span = 2.0 + static_cast<int>(draw(1) * 6);
    Polygon ring;
    for (std::uint32_t i = 0; ring.size() < n && i < 40; ++i) {
      const vec2 p{static_cast<int>(draw(2 + 2 * i) * span), static_cast<int>(draw(3 + 2 * i) * span)};
      if (ring.empty() || ring.back() != p) ring.push_back(p);
    }
    if (ring.size() < 3 || ring.front() == ring.back()) continue;
    const bool expected = simple_by_brute_force(ring);
    ++(expected ? simple : faulty);
    ASSERT_EQ(!region_fault(ring, {}).has_value(), expected) << "round " << round;
  }
  EXPECT_GT(simple, 5'000);
  EXPECT_GT(faulty, 5'000);
}

// A hole is inside if all its vertices and all middles of its edges are, its edges cross none, and no outline vertex is inside
// it.
TEST(RegionFault, AgreesWithPointTestsForHoles) {
  int good = 0;
  int bad = 0;
  for (std::uint32_t round = 0; round < 120'000; ++round) {
    const auto draw = [&](std::uint32_t i) {
      return static_cast<int>(uniform(2, {Stream::turn, Id("hole").child(round), i}) * 7) * 2.0;
    };
    const Polygon a = {{draw(0), draw(1)}, {draw(2), draw(3)}, {draw(4), draw(5)}, {draw(6), draw(7)}};
    const Polygon b = {{draw(8), draw(9)}, {draw(10), draw(11)}, {draw(12), draw(13)}};
    const auto degenerate = [](const Polygon& p) {
      for (std::size_t i = 0; i < p.size(); ++i) {
        if (p[i] == p[(i + 1) % p.size()]) return true;
      }
      return !simple_by_brute_force(p);
    };
    if (degenerate(a) || degenerate(b)) continue;
    // The triangle is convex: with proper crossings ruled out, it lies inside iff its edges, cut at outline vertices, do.
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const vec2 p = b[i];
      const vec2 q = b[(i + 1) % 3];
      std::vector<vec2> cuts = {p, q};
      for (std::size_t j = 0; j < a.size(); ++j) {
        const vec2 r = a[j];
        const vec2 s = a[(j + 1) % a.size()];
        if (segments_cross(to_lattice(p), to_lattice(q), to_lattice(r), to_lattice(s))) inside = false;
        if (on_segment(to_lattice(p), to_lattice(q), to_lattice(r))) cuts.push_back(r);
        const bool collinear = side(to_lattice(p), to_lattice(q), to_lattice(r)) == Side::on &&
                               side(to_lattice(p), to_lattice(q), to_lattice(s)) == Side::on;
        const vec2 d = q - p;
        const double r_at = glm::dot(r - p, d);
        const double s_at = glm::dot(s - p, d);
        if (collinear && std::max(r_at, s_at) > 0 && std::min(r_at, s_at) < glm::dot(d, d)) inside = false;
      }
      std::ranges::sort(cuts, [&](vec2 u, vec2 v) { return glm::dot(u - p, q - p) < glm::dot(v - p, q - p); });
      for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
        if (!contains(a, 0.5 * (cuts[c] + cuts[c + 1]))) inside = false;
      }
    }
    const auto within_hole = [&](vec2 v) {
      return contains(b, v) && !on_segment(to_lattice(b[0]), to_lattice(b[1]), to_lattice(v)) &&
             !on_segment(to_lattice(b[1]), to_lattice(b[2]), to_lattice(v)) &&
             !on_segment(to_lattice(b[2]), to_lattice(b[0]), to_lattice(v));
    };
    if (std::ranges::any_of(a, within_hole)) inside = false;
    ++(inside ? good : bad);
    ASSERT_EQ(!region_fault(a, {b}).has_value(), inside) << "round " << round;
  }
  EXPECT_GT(good, 300);
  EXPECT_GT(bad, 5'000);
}

// Long parallel edges are what a grid or boxes are slow at: 200,000 of them must take seconds, not hours.
TEST(RegionFault, TakesNearlyLinearTimeForZigzags) {
  Polygon comb;
  constexpr int teeth = 100'000;
  for (int i = 0; i < teeth; ++i) {
    comb.push_back({0.01 * i, 0.0});
    comb.push_back({500.0 + 0.01 * i, 900.0});
  }
  comb.push_back({0.01 * teeth + 1000.0, -1.0});
  comb.push_back({0.0, -1.0});
  EXPECT_FALSE(region_fault(comb, {}).has_value());
}

TEST(OrientedRegion, TurnsOutlineLeftAndHolesRight) {
  const Polygon hole = {{2, 2}, {4, 2}, {4, 4}};
  const Region region = oriented_region(reversed(plain_square), {hole});
  EXPECT_GT(area(region.outline), 0.0);
  EXPECT_LT(area(region.holes[0]), 0.0);
  EXPECT_EQ(region.outline.front(), reversed(plain_square).front());
}

}  // namespace
}  // namespace shatterpave::geometry
