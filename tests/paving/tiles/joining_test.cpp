#include "paving/tiles/joining.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.h"
#include "geometry/contacts.h"
#include "geometry/hull.h"
#include "geometry/lattice.h"
#include "paving/laying.h"
#include "paving/layout_quality.h"
#include "paving/paved_areas.h"
#include "paving/tiles/contact.h"

namespace shatterpave::paving {
namespace {

using geometry::Polygon;

TEST(Contact, IsWhereSidesRunAgainstEachOther) {
  const Polygon low{{0, 0}, {10, 0}, {10, 5}, {0, 5}};
  const Polygon high{{4, 5}, {14, 5}, {14, 9}, {4, 9}};
  const auto found = contacts(low, high);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().side, 2U);
  EXPECT_EQ(found.front().from_mm, 0.0);
  EXPECT_EQ(found.front().to_mm, 6.0);
  EXPECT_EQ(shared_length(low, high), 6.0);
  EXPECT_EQ(shared_length(low, Polygon{{0, 6}, {10, 6}, {10, 9}, {0, 9}}), 0.0);
}

TEST(Contact, JoinsWhatWasRoundedForEach) {
  const Polygon low{{0, 0}, {10, 0}, {10, 5}, {0, 5}};
  const Polygon high{{0, 5.001}, {10, 5}, {10, 9}, {0, 9}};
  const auto together = joined(low, high);
  ASSERT_TRUE(together.has_value());
  EXPECT_EQ(together->size(), 4U);
  EXPECT_NEAR(geometry::area(*together), 90.0, 0.01);
  EXPECT_FALSE(joined(low, Polygon{{0, 6}, {10, 6}, {10, 9}, {0, 9}}).has_value());
}

// Where a side of a lattice unit is left, the corner beside it is the nearer one of its two ends. From a real plan.
TEST(Contact, JoinsBesideASideOfALatticeUnit) {
  const Polygon small{{-19376.395, -21663.708}, {-19659.084, -21701.377}, {-19552.861, -21715.577}};
  const Polygon large{{-19376.395, -21663.708},
                      {-19545.107, -21339.005},
                      {-19667.769, -21360.739},
                      {-19659.085, -21701.377},
                      {-19659.084, -21701.377}};
  const auto together = joined(small, large);
  ASSERT_TRUE(together.has_value());
  EXPECT_NEAR(geometry::area(*together), geometry::area(small) + geometry::area(large), 0.01);
}

Pavement rows(Bond bond, double height_mm) {
  Pavement paved = pavement({{{0, 0}, {2000, 0}, {2000, height_mm}, {0, height_mm}}, {}}, 100, 8, ConstantDirection{});
  paved.stone_mm = {192, 92};
  paved.bonding.bond = bond;
  return paved;
}

// A strip of 10 mm is left above the last row, half a stone off the one that would be next. No stone is deep enough for both:
// each of the last row and its part of the strip are cut anew, as two of one depth.
TEST(Joining, CutsTheLastRowAnewWithAStripBesideIt) {
  for (const Bond bond : {Bond::running, Bond::stack}) {
    const Pavement paved = rows(bond, 410);
    const StoneLayout layout = laid_stones(paved, 1);
    EXPECT_EQ(faults(paved, layout).total(), 0U);
    EXPECT_GE(quality(paved, layout).coverage, 0.998);
    std::size_t anew = 0;
    for (const Stone& stone : layout.stones) {
      EXPECT_EQ(stone.outline_mm.size(), 4U) << "stone " << stone.id;
      const geometry::Box box = geometry::bounding_box(stone.outline_mm);
      EXPECT_LE(box.high.x - box.low.x, 192.001);
      EXPECT_LE(box.high.y - box.low.y, 92.001);
      if (box.low.y < 300.0) continue;
      ++anew;
      EXPECT_NEAR(box.high.y - box.low.y, 0.5 * (110.0 - 2.0 * 8.0), 0.01);
    }
    EXPECT_EQ(anew, bond == Bond::stack ? 20U : 22U);
  }
}

// Whatever is cut: stones of rows stay convex, since no joint of theirs needs to be bent.
// A small piece that touches a large one by a side hardly longer than the joint would fall off again when the joint is taken.
TEST(Joining, LeavesNoBedBareWhereANeckWouldBreak) {
  Pavement paved = pavement({{{0, 0}, {1900, 0}, {1900, 1500}, {0, 1500}}, {}}, 340, 14, ConstantDirection{});
  paved.bonding.bond = Bond::crazy;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    // Strips of up to 1.5 % of a stone's side along the border are left to the joint.
    EXPECT_GE(quality(paved, laid_stones(paved, seed)).coverage, 0.996) << "seed " << seed;
  }
}

TEST(Joining, LeavesStonesOfRowsConvexOnSlantedBorders) {
  for (const double degrees : {3.0, 11.0, 30.0, 52.0}) {
    Pavement paved = rows(Bond::running, 1234);
    paved.direction = ConstantDirection{Angle::degrees(degrees)};
    const StoneLayout layout = laid_stones(paved, 1);
    EXPECT_EQ(faults(paved, layout).total(), 0U);
    double hollow = 0.0;
    double all = 0.0;
    for (const Stone& stone : layout.stones) {
      hollow += geometry::area(geometry::convex_hull(stone.outline_mm)) - geometry::area(stone.outline_mm);
      all += geometry::area(stone.outline_mm);
    }
    // A few beside the border are notched, where two stones that fit their stock could not be made of them.
    EXPECT_LT(hollow, 0.006 * all) << degrees;
  }
}

// Hourglasses, their necks turned any way and as wide as the joint but for some steps of the lattice: two faces are left, or
// one.
TEST(Faces, NeverMeetInAPoint) {
  int in_two = 0;
  for (std::uint32_t draw = 0; draw < 1000; ++draw) {
    const auto next = [&](std::uint32_t which) { return uniform(1, {Stream::stone_place, Id("hourglass"), 4 * draw + which}); };
    const double half = 5.0 + 0.004 * (next(0) - 0.5);
    const vec2 neck = half * Angle::degrees(80.0 * (next(1) - 0.5)).direction();
    const vec2 middle{50.0, 50.0 + 4.0 * next(2)};
    const double side = 90.0 + 20.0 * next(3);
    Polygon piece{{0.0, 0.0}, {side, 0.0}, middle + neck, {side, 100.0}, {0.0, 100.0}, middle - neck};
    for (vec2& p : piece) p = geometry::on_lattice(p);
    const auto faces = faces_of(piece, 10.0);
    ASSERT_FALSE(faces.empty());
    EXPECT_TRUE(geometry::contacts(faces).empty()) << draw;
    if (faces.size() == 2) ++in_two;
  }
  EXPECT_GT(in_two, 250);
}

// Layout 19,286 of the long run: hexagons where directions meet, and a joint of 19.1 mm.
TEST(Faces, ArePartedWhereTheJointLeavesAPoint) {
  const Polygon piece{{5880.831, -6096.609}, {5841.429, -6073.563}, {5844.508, -6145.582},
                      {5848.155, -6149.055}, {5879.178, -6118.655}, {5879.548, -6170.617},
                      {5914.408, -6170.368}, {5914.253, -6148.584}, {5934.975, -6128.278}};
  const auto faces = faces_of(piece, 19.1);
  EXPECT_EQ(faces.size(), 2U);
  EXPECT_TRUE(geometry::contacts(faces).empty());
}

}  // namespace
}  // namespace shatterpave::paving
