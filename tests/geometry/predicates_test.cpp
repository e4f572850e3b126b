#include "geometry/predicates.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/random.h"

namespace shatterpave::geometry {
namespace {

using boost::multiprecision::cpp_int;

// A fraction, with the few operations that these tests need.
struct Fraction {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;

  bool within_unit() const { return 0 <= scaled() && scaled() <= std::abs(denominator); }
  bool inside_unit() const { return 0 < scaled() && scaled() < std::abs(denominator); }
  bool times_is(std::int64_t factor, std::int64_t product) const { return numerator * factor == product * denominator; }

 private:
  std::int64_t scaled() const { return denominator < 0 ? -numerator : numerator; }
};

std::int64_t drawn_number(std::uint32_t i, std::uint64_t which, std::int64_t low, std::int64_t high) {
  const double u = uniform(2, {Stream::turn, Id("coordinate").child(which), i});
  return low + static_cast<std::int64_t>(u * static_cast<double>(high - low + 1));
}

LatticePoint drawn_point(std::uint32_t i, std::uint64_t which, std::int64_t largest) {
  return {drawn_number(i, 2 * which, -largest, largest), drawn_number(i, 2 * which + 1, -largest, largest)};
}

// The sign of the determinant, in whole numbers of any length.
Side oracle_side(LatticePoint a, LatticePoint b, LatticePoint c) {
  const cpp_int determinant = (cpp_int(b.x) - a.x) * (cpp_int(c.y) - a.y) - (cpp_int(b.y) - a.y) * (cpp_int(c.x) - a.x);
  return static_cast<Side>(determinant.sign());
}

// Whether a + t (b - a) = c for a t in [0, 1], in fractions.
bool oracle_on_segment(LatticePoint a, LatticePoint b, LatticePoint c) {
  if (a == b) return c == a;
  const bool steep = a.x == b.x;
  const Fraction t = steep ? Fraction{c.y - a.y, b.y - a.y} : Fraction{c.x - a.x, b.x - a.x};
  return t.within_unit() && t.times_is(b.x - a.x, c.x - a.x) && t.times_is(b.y - a.y, c.y - a.y);
}

struct Meeting {
  bool meet = false;
  bool cross = false;
};

// Solves a + t (b - a) = c + u (d - c) by Cramer's rule; parallel segments meet where an end of one lies on the other.
Meeting oracle_meeting(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const LatticePoint p{b.x - a.x, b.y - a.y};
  const LatticePoint q{d.x - c.x, d.y - c.y};
  const LatticePoint r{c.x - a.x, c.y - a.y};
  const std::int64_t determinant = p.x * q.y - p.y * q.x;
  if (determinant == 0) {
    return {
        oracle_on_segment(a, b, c) || oracle_on_segment(a, b, d) || oracle_on_segment(c, d, a) || oracle_on_segment(c, d, b),
        false};
  }
  const Fraction t{r.x * q.y - r.y * q.x, determinant};
  const Fraction u{r.x * p.y - r.y * p.x, determinant};
  return {t.within_unit() && u.within_unit(), t.inside_unit() && u.inside_unit()};
}

TEST(Predicates, SideOfFarAndNearlyStraightPointsIsExact) {
  // The largest coordinates of a scene; c is moved to within a few units of the line, where doubles would fail.
  const std::int64_t largest = to_lattice(largest_coordinate_mm);
  std::array<int, 3> sides = {0, 0, 0};
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const LatticePoint a = drawn_point(i, 0, largest);
    // b and c on a line through a in whole steps, then c moved by at most one unit.
    const LatticePoint step = {drawn_number(i, 2, -largest / 4, largest / 4), drawn_number(i, 3, -largest / 4, largest / 4)};
    const LatticePoint b{a.x + step.x, a.y + step.y};
    const LatticePoint c{a.x + 3 * step.x + drawn_number(i, 4, -1, 1), a.y + 3 * step.y + drawn_number(i, 5, -1, 1)};
    ASSERT_EQ(side(a, b, c), oracle_side(a, b, c));
    ++sides[static_cast<std::size_t>(static_cast<std::int64_t>(side(a, b, c)) + 1)];
  }
  for (const int count : sides) EXPECT_GT(count, 1000) << "each side must be reached often";
}

TEST(Predicates, SidesFollowFromTheOrderOfPoints) {
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const LatticePoint a = drawn_point(i, 10, 5);
    const LatticePoint b = drawn_point(i, 11, 5);
    const LatticePoint c = drawn_point(i, 12, 5);
    EXPECT_EQ(side(a, b, c), side(b, c, a));
    EXPECT_EQ(static_cast<int>(side(a, b, c)), -static_cast<int>(side(b, a, c)));
  }
}

// On a lattice as small as this every way in which segments can touch, overlap or shrink to a point comes about.
TEST(Predicates, SegmentsAgreeWithFractions) {
  std::array<int, 4> reached = {0, 0, 0, 0};
  for (std::uint32_t i = 0; i < 200000; ++i) {
    const LatticePoint a = drawn_point(i, 20, 3);
    const LatticePoint b = drawn_point(i, 21, 3);
    const LatticePoint c = drawn_point(i, 22, 3);
    const LatticePoint d = drawn_point(i, 23, 3);
    const Meeting expected = oracle_meeting(a, b, c, d);
    ASSERT_EQ(segments_meet(a, b, c, d), expected.meet);
    ASSERT_EQ(segments_cross(a, b, c, d), expected.cross);
    ASSERT_EQ(on_segment(a, b, c), oracle_on_segment(a, b, c));
    const bool parallel = (b.x - a.x) * (d.y - c.y) == (b.y - a.y) * (d.x - c.x);
    reached[0] += expected.cross ? 1 : 0;
    reached[1] += expected.meet && !expected.cross && !parallel ? 1 : 0;
    reached[2] += expected.meet && parallel ? 1 : 0;
    reached[3] += expected.meet ? 0 : 1;
  }
  for (const int count : reached) EXPECT_GT(count, 1000) << "cross, touch, overlap, miss must each be reached often";
}

TEST(Lattice, RoundsToTheNearestMicrometre) {
  EXPECT_EQ(to_lattice(150.1234), 150123);
  EXPECT_EQ(to_lattice(-0.0006), -1);
  EXPECT_EQ(on_lattice({0.0004, 2.0}), (vec2{0.0, 2.0}));
  for (std::uint32_t i = 0; i < 5000; ++i) {
    const LatticePoint p = drawn_point(i, 30, to_lattice(largest_coordinate_mm));
    ASSERT_EQ(to_lattice(to_mm(p)), p) << "a point of the lattice comes back from millimetres";
  }
}

}  // namespace
}  // namespace shatterpave::geometry
