#include "paving/tiles/stock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/clip.h"
#include "paving/bonds/bond.h"
#include "paving/bonds/border.h"
#include "paving/laying.h"
#include "paving/layout_quality.h"
#include "paving/paved_areas.h"

namespace shatterpave::paving {
namespace {

using geometry::Polygon;

TEST(Stock, StonesFitAlongTheirAxis) {
  const Polygon stone{{0, 0}, {200, 0}, {200, 100}, {0, 100}};
  const Stock stock{{200, 100}, 20000, {}, {1, 0}};
  EXPECT_TRUE(fits(stone, {1, 0}, stock));
  EXPECT_FALSE(fits(stone, {0, 1}, stock));
  EXPECT_FALSE(fits({{0, 0}, {200.01, 0}, {200.01, 100}, {0, 100}}, {1, 0}, stock));
  // Stones that lie across have another size.
  const Stock turned{{300, 200}, 60000, {200, 100}, {0, 1}};
  EXPECT_TRUE(fits(stone, {1, 0}, turned));
  EXPECT_FALSE(fits({{0, 0}, {300, 0}, {300, 100}, {0, 100}}, {1, 0}, turned));
  EXPECT_TRUE(fits({{0, 0}, {200, 0}, {200, 300}, {0, 300}}, {0, 1}, turned));
}

TEST(Stock, TrimmingTakesBothEndsAlike) {
  const auto parts = trimmed({{0, 0}, {210, 0}, {210, 90}, {0, 90}}, {1, 0}, {{200, 100}, 20000, {}, {1, 0}});
  ASSERT_EQ(parts.size(), 1U);
  const geometry::Box box = geometry::bounding_box(parts.front());
  EXPECT_EQ(box.low, vec2(5, 0));
  EXPECT_EQ(box.high, vec2(205, 90));
}

TEST(Stock, HalvesHaveOneAreaAndFit) {
  const Polygon wedge{{0, 0}, {300, 0}, {300, 100}, {0, 20}};
  const auto parts = halves(wedge, {1, 0}, true, 250.0);
  ASSERT_TRUE(parts.has_value());
  EXPECT_NEAR(geometry::area(parts->first), 9000.0, 0.5);
  EXPECT_NEAR(geometry::area(parts->second), 9000.0, 0.5);
  EXPECT_FALSE(halves(wedge, {1, 0}, true, 140.0).has_value());
}

// The cases of users' reports, with what was wrong: stones over one another, a stone of 2.7 m, triangles left bare.
Pavement reported(Polygon outline, vec2 stone_mm, Bond bond, Direction direction, BorderCourse course = BorderCourse::none) {
  Pavement result = pavement({std::move(outline), {}}, 100, 8, std::move(direction));
  result.stone_mm = stone_mm;
  result.bonding.bond = bond;
  result.border.course = course;
  return result;
}

struct Report {
  const char* name;
  Pavement pavement;
};

std::vector<Report> reports() {
  const Polygon yard{{0, 0}, {4000, 0}, {4000, 3000}, {0, 3000}};
  const Direction bent = GuidesDirection{{{{1500, 800}, {3700, 100}, {2400, 400}}}};
  return {
      {"triangle", reported({{3200, 2700}, {1200, 200}, {1600, 1000}}, {200, 100}, Bond::running, BoundaryDirection{})},
      {"pentagon", reported({{1000, 1500}, {1000, 2300}, {1300, 1300}, {2900, 100}, {2000, 500}}, {200, 100}, Bond::running,
                            BoundaryDirection{})},
      {"sharp_guide", reported(yard, {150, 150}, Bond::stack, bent)},
      {"needle_with_border",
       reported({{0, 0}, {9000, 0}, {4500, 300}}, {200, 100}, Bond::packed, straight(0), BorderCourse::soldier)},
      {"one_guide", reported(yard, {200, 100}, Bond::packed, GuidesDirection{{{{2200, 300}, {3300, 400}}}})},
      // Of the same kinds.
      {"two_guides_that_cross",
       reported(yard, {200, 100}, Bond::running,
                GuidesDirection{{{{0, 500}, {3900, 2800}}, {{300, 2900}, {2000, 200}, {3500, 1500}}}})},
      {"star", reported({{0, 0}, {1500, 900}, {3000, 0}, {2100, 1500}, {3000, 3000}, {1500, 2100}, {0, 3000}, {900, 1500}},
                        {120, 80}, Bond::stack, BoundaryDirection{})},
      {"fan_with_soldiers",
       reported({{0, 0}, {2600, 100}, {1700, 2500}}, {90, 90}, Bond::fan, straight(20), BorderCourse::soldier)},
      {"rings_about_a_corner", reported(yard, {200, 100}, Bond::running, RadialDirection{{100, 150}})},
      {"herringbone_with_stretchers", reported({{0, 0}, {5000, 0}, {5000, 900}, {0, 250}}, {200, 100}, Bond::herringbone,
                                               straight(10), BorderCourse::stretcher)},
      {"guide_beside_the_sides", reported(yard, {100, 100}, Bond::packed, GuidesDirection{{{{100, 100}, {3900, 700}}}})},
  };
}

class ReportedPlan : public testing::TestWithParam<Report> {};

TEST_P(ReportedPlan, HasNoOverlapNoGiantAndNoBareSpot) {
  const Pavement& paved = GetParam().pavement;
  const StoneLayout layout = laid_stones(paved, 1);
  EXPECT_EQ(faults(paved, layout).total(), 0U);
  const Stock field = stock(paved);
  const Stock border{border_stone_mm(paved), border_stone_mm(paved).x * border_stone_mm(paved).y, {}, {1, 0}};
  // With their tips, which are cut off half a joint's width before the joint ends.
  std::vector<Polygon> grown;
  for (const Stone& stone : layout.stones) {
    EXPECT_TRUE(fits(stone.outline_mm, stone.angle.direction(), stone.part == StonePart::border ? border : field)) << stone.id;
    for (const geometry::Region& region : geometry::offset({stone.outline_mm, {}}, 0.51 * paved.joint_mm, 20.0)) {
      grown.push_back(region.outline);
    }
  }
  // Nothing is left in which a disc of a tenth of the longer side fits, half a joint from the border.
  const double widest = 0.1 * std::max(paved.stone_mm.x, paved.stone_mm.y);
  for (const geometry::Region& inside : geometry::offset(paved.area, -0.5 * paved.joint_mm, 5.0)) {
    for (const geometry::Region& bare : geometry::difference(inside, grown)) {
      EXPECT_TRUE(geometry::offset(bare, -0.5 * widest).empty()) << bare.outline.front().x << ", " << bare.outline.front().y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Reports, ReportedPlan, testing::ValuesIn(reports()),
                         [](const auto& named) { return std::string(named.param.name); });

}  // namespace
}  // namespace shatterpave::paving
