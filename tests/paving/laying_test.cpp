#include "paving/laying.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "paving/layout_quality.h"
#include "paving/paved_areas.h"

namespace shatterpave::paving {
namespace {

Direction straight(double degrees) { return ConstantDirection{Angle::degrees(degrees)}; }

TEST(Laying, WholeStonesOfAStraightPathAreExact) {
  // 432 = 4 pitches of 108, so all twelve stones are whole, and 4 mm, half a joint, stay free along the outline.
  const geometry::Region area{{{0, 0}, {432, 0}, {432, 324}, {0, 324}}, {}};
  const StoneLayout layout = laid_stones(pavement(area, 100, 8, straight(0)), 1);
  ASSERT_EQ(layout.stones.size(), 12U);
  for (const Stone& stone : layout.stones) {
    EXPECT_EQ(stone.kind, StoneKind::whole);
    EXPECT_EQ(geometry::area(stone.outline_mm), 10000.0);
    EXPECT_EQ(stone.angle, Angle());
  }
  const geometry::Box first = geometry::bounding_box(layout.stones.front().outline_mm);
  EXPECT_EQ(first.low, vec2(4, 4));
  EXPECT_EQ(first.high, vec2(104, 104));
}

TEST(Laying, StraightRowsAreExactOnAnyOutline) {
  for (const double degrees : {0.0, 30.0, 77.0}) {
    for (const geometry::Region& area : {path_area(), concave_area()}) {
      const Pavement paved = pavement(area, 100, 8, straight(degrees));
      const StoneLayout layout = laid_stones(paved, 1);
      EXPECT_EQ(faults(paved, layout).total(), 0U);
      const LayoutQuality q = quality(paved, layout);
      EXPECT_GT(q.whole, q.stones / 2);
      EXPECT_LT(q.p95_misalignment_deg, 0.01);
      EXPECT_EQ(q.four_sided, 1.0);
      EXPECT_GT(q.coverage, 0.995);
      EXPECT_GE(q.smallest, 0.25);
    }
  }
}

TEST(Laying, RefusesTooManyStonesAndSaysHowMany) {
  const geometry::Region area{{{0, 0}, {900000, 0}, {900000, 900000}, {0, 900000}}, {}};
  try {
    static_cast<void>(laid_stones(pavement(area, 100, 8, straight(0)), 1));
    FAIL() << "69 million stones were laid";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("694"), std::string::npos) << error.what();
  }
}

// The oracle itself must see what is wrong.
TEST(LayoutFaults, SeesOverlapAndStonesOutside) {
  const Pavement paved = pavement(path_area(), 100, 8, straight(0));
  StoneLayout layout = laid_stones(paved, 1);
  const auto moved = [&](std::size_t s, vec2 by) {
    StoneLayout other = layout;
    for (vec2& p : other.stones[s].outline_mm) p += by;
    return faults(paved, other);
  };
  EXPECT_EQ(moved(0, {3, 0}).total(), 0U);
  EXPECT_EQ(moved(0, {9, 0}).overlaps, 1U);
  EXPECT_EQ(moved(0, {-5, 0}).outside, 1U);
}

}  // namespace
}  // namespace shatterpave::paving
