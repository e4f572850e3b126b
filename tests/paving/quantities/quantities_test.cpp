#include "paving/quantities/quantities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "paving/bonds/bond.h"
#include "paving/bonds/border.h"
#include "paving/laying.h"
#include "paving/paved_areas.h"

namespace shatterpave::paving {
namespace {

// Nine stones of 200 × 100 and joints of 10 in three rows, with half a joint about them.
Pavement nine_stones() {
  Pavement result = pavement({{{0, 0}, {630, 0}, {630, 330}, {0, 330}}, {}}, 100, 10, straight(0));
  result.stone_mm = {200, 100};
  result.bonding.bond = Bond::stack;
  return result;
}

TEST(Quantities, CountNineWholeStonesAndTheirJoints) {
  const Pavement asked = nine_stones();
  const Quantities found = quantities(asked, laid_stones(asked, 1));
  ASSERT_EQ(found.parts.size(), 1U);
  EXPECT_EQ(found.parts[0].part, StonePart::field);
  EXPECT_EQ(found.parts[0].whole.count, 9U);
  EXPECT_EQ(found.parts[0].cut.count, 0U);
  EXPECT_EQ(found.parts[0].order, 9U);
  EXPECT_EQ(found.parts[0].order_reusing, 9U);
  EXPECT_NEAR(found.paved_mm2, 630.0 * 330.0, 1e-6);
  EXPECT_NEAR(found.joint_mm2, 630.0 * 330.0 - 9 * 20000.0, 1e-6);
  // Between rows twice 3 × 200, between columns twice 3 × 100; each side of a joint is as long as the stones beside it.
  EXPECT_NEAR(found.joint_mm, 2 * 600.0 + 2 * 300.0, 1e-6);
}

TEST(Quantities, OffcutsServeAgain) {
  Pavement asked = nine_stones();
  asked.bonding.bond = Bond::running;
  const StoneLayout layout = laid_stones(asked, 1);
  const Quantities found = quantities(asked, layout);
  ASSERT_EQ(found.parts.size(), 1U);
  const PartQuantities& part = found.parts[0];
  // Each second row begins and ends with a half: 95 mm, of which two and the saw are one stone.
  ASSERT_GT(part.cut.count, 1U);
  EXPECT_EQ(part.order, layout.stones.size());
  EXPECT_EQ(part.order_reusing, part.whole.count + (part.cut.count + 1) / 2);
  std::map<std::size_t, int> uses;
  for (const std::size_t stock : found.stock_of_stone) ++uses[stock];
  EXPECT_EQ(uses.size(), part.order_reusing);
}

TEST(Quantities, BorderStonesAreOrderedApart) {
  Pavement asked = pavement({{{0, 0}, {2000, 0}, {2000, 1500}, {0, 1500}}, {}}, 100, 8, straight(0));
  asked.stone_mm = {200, 100};
  asked.bonding.bond = Bond::herringbone;
  asked.border.course = BorderCourse::soldier;
  const StoneLayout layout = laid_stones(asked, 3);
  const Quantities found = quantities(asked, layout);
  ASSERT_EQ(found.parts.size(), 2U);
  EXPECT_EQ(found.parts[1].part, StonePart::border);
  EXPECT_EQ(found.parts[1].stock_mm, vec2(100, 200));
  double faces = 0.0;
  for (const Stone& stone : layout.stones) faces += geometry::area(stone.outline_mm);
  double told = 0.0;
  for (const PartQuantities& part : found.parts) {
    told += part.whole.area_mm2 + part.cut.area_mm2;
    EXPECT_LE(part.order_reusing, part.order);
    EXPECT_GE(static_cast<double>(part.order_reusing) * part.stock_area_mm2, part.whole.area_mm2 + part.cut.area_mm2);
  }
  EXPECT_NEAR(told, faces, 1e-3);
}

// Length times width is the area, but for crossings and the half joints along the border.
TEST(Quantities, JointsAreAsLongAsTheirAreaSays) {
  for (const Bond bond : {Bond::running, Bond::stack, Bond::herringbone, Bond::hexagon, Bond::basket_weave}) {
    Pavement asked = pavement({{{0, 0}, {6000, 0}, {6000, 5000}, {0, 5000}}, {}}, 100, 5, straight(20));
    asked.stone_mm = {200, bond == Bond::hexagon ? 200.0 : 100.0};
    asked.bonding.bond = bond;
    const Quantities found = quantities(asked, laid_stones(asked, 1));
    const double along_border = 22000.0 * 0.5 * asked.joint_mm;
    EXPECT_NEAR(found.joint_mm * asked.joint_mm, found.joint_mm2 - along_border, 0.06 * found.joint_mm2)
        << static_cast<int>(bond);
  }
}

// What is laid along curves has no stock of one size.
TEST(Quantities, StonesAlongABendAreOrderedOneByOne) {
  const Pavement asked = pavement(quarter_annulus(), 300, 8, RadialDirection{});
  const Quantities found = quantities(asked, laid_stones(asked, 1));
  ASSERT_FALSE(found.parts.empty());
  EXPECT_GT(found.parts[0].cut.count, 0U);
  EXPECT_EQ(found.parts[0].order_reusing, found.parts[0].order);
}

}  // namespace
}  // namespace shatterpave::paving
