#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/clip.h"
#include "geometry/region_index.h"
#include "measure/hand_figures.h"
#include "paving/bonds/bond.h"
#include "paving/bonds/border.h"
#include "paving/bonds/table.h"
#include "paving/catalogue/hand_presets.h"
#include "paving/laying.h"
#include "paving/layout_quality.h"
#include "paving/paved_areas.h"
#include "paving/tiles/hand_setting.h"
#include "paving/tiles/hand_stones.h"
#include "paving/tiles/stock.h"
#include "scene/plans/plan_areas.h"
#include "support/laws.h"
#include "support/shared_data.h"

namespace shatterpave::paving {
namespace {

Pavement by_hand(const BondType& type, double amount, const Direction& direction) {
  Pavement paved = pavement(concave_area(), 100, 8, direction);
  const ShapeLimits shapes = type.shapes;
  if (shapes.least >= 1.0) paved.stone_mm = {200, 100};
  paved.bonding.bond = type.id;
  paved.hand.amount = amount;
  return paved;
}

TEST(HandLaying, NeverLetsStonesTouchOrLeaveTheArea) {
  std::uint64_t seed = 1;
  for (const BondType* type : bond_types()) {
    if (!type->is_for_scenes) continue;
    for (const Direction& direction :
         {straight(20), Direction(BoundaryDirection{}), Direction(RadialDirection{{-500, -800}, 0.0})}) {
      Pavement paved = by_hand(*type, 1.0, direction);
      if (seed % 2 == 0) paved.border.course = BorderCourse::soldier;
      const StoneLayout layout = laid_stones(paved, ++seed);
      EXPECT_EQ(faults(paved, layout).total(), 0U) << std::string_view(type->name) << " " << seed;
    }
  }
}

// What was joined of small pieces, too, in spite of the joint that it moves into.
TEST(HandLaying, EveryStoneFitsItsStock) {
  std::uint64_t seed = 1;
  std::size_t stones = 0;
  for (const BondType* type : bond_types()) {
    if (!type->is_for_scenes) continue;
    for (const Direction& direction : {straight(20), Direction(BoundaryDirection{})}) {
      Pavement paved = by_hand(*type, 0.2, direction);
      paved.joint_mm = 30;
      if (seed % 2 == 0) paved.border.course = BorderCourse::soldier;
      const vec2 border = border_stone_mm(paved);
      const Stock of_border = hand_stock({border, border.x * border.y, {}, {1.0, 0.0}}, paved.joint_mm, paved.hand.amount);
      for (const Stone& stone : laid_stones(paved, ++seed).stones) {
        const Stock its = stone.part == StonePart::border ? of_border : stock(paved);
        EXPECT_TRUE(fits(stone.outline_mm, stone.angle.direction(), its))
            << std::string_view(type->name) << " " << seed << " " << stone.id;
        ++stones;
      }
    }
  }
  EXPECT_GT(stones, 2000U);
}

// A ring about a place within is a line that comes back to where it began, at a point where a perpend goes on.
TEST(HandLaying, NeverLetsStonesTouchAboutACentreWithin) {
  for (const Bond bond : {Bond::stack, Bond::running}) {
    for (const vec2 centre : {vec2{500, 500}, vec2{900, 700}, vec2{1300, 450}}) {
      const Pavement paved = by_hand(type_of(bond), 1.0, RadialDirection{centre, 0.0});
      for (const std::uint64_t seed : {1U, 2U, 3U}) {
        EXPECT_EQ(faults(paved, laid_stones(paved, seed)).total(), 0U) << centre.x << " " << centre.y << " " << seed;
      }
    }
  }
}

// Corners of the border's tiles lie 3 µm apart where these taper: numbers 1267 and 16845 of the random layouts.
TEST(HandLaying, NeverLetsTilesThatTaperLieOverOthers) {
  Pavement star = pavement({}, 116, 0, BoundaryDirection{});
  star.area = {{{1719.035, 11580.833},
                {714.885, 12450.753},
                {-652.548, 12120.805},
                {-1541.420, 12665.606},
                {-1775.679, 12013.857},
                {-3350.836, 12063.602},
                {-2275.519, 11580.833},
                {-3350.836, 11098.064},
                {-1775.679, 11147.809},
                {-1541.420, 10496.061},
                {-652.548, 11040.861},
                {714.885, 10710.913},
                {248.133, 11340.523}},
               {{{-152.359, 11467.170}, {-236.920, 11029.411}, {129.759, 11098.168}}}};
  star.area.outline.insert(star.area.outline.begin() + 1, vec2{248.133, 11821.143});
  star.bonding.bond = Bond::hexagon;
  star.border.course = BorderCourse::soldier;
  star.hand.amount = 0.257;
  Pavement slim = pavement({}, 169, 0, BoundaryDirection{});
  slim.area.outline = {{10937.166, -18360.227}, {10699.843, -18251.305}, {10802.383, -18187.834}, {12160.152, -18277.417},
                       {12997.314, -20161.562}, {11544.845, -19167.842}, {11320.847, -20542.898}, {11103.079, -20544.516},
                       {10604.440, -20450.400}, {11647.360, -18391.343}};
  slim.bonding.bond = Bond::crazy;
  slim.border.course = BorderCourse::soldier;
  slim.border.stone_mm = vec2{70.9, 113.4};
  slim.hand.amount = 1.0;
  slim.hand.rounded = 0.068;
  slim.hand.nibbled = 0.654;
  for (Pavement* paved : {&star, &slim}) {
    paved->name = "court";
    if (geometry::area(paved->area.outline) < 0.0) std::ranges::reverse(paved->area.outline);
    for (geometry::Polygon& hole : paved->area.holes) {
      if (geometry::area(hole) > 0.0) std::ranges::reverse(hole);
    }
    EXPECT_EQ(faults(*paved, laid_stones(*paved, paved == &star ? 392 : 235)).total(), 0U);
  }
}

// Every corner of a stone whose corners are all nibbled has lost more on one of its sides, on either as often.
TEST(HandLaying, NibbledCornersHaveLostMoreOnOneSide) {
  Pavement paved = by_hand(type_of(Bond::running), 0.0, straight(0));
  paved.hand.rounded = 0.0;
  paved.hand.nibbled = 1.0;
  const geometry::Polygon outline = {{0, 0}, {300, 0}, {300, 200}, {0, 200}};
  double on_the_first = 0.0;  // of a corner's two sides, counter-clockwise
  double count = 0.0;
  for (std::uint64_t stone = 0; stone < 1000; ++stone) {
    const geometry::Polygon face = hand_face(outline, paved, 0.0, 3, Id("a").child(stone));
    for (std::size_t i = 0; i < outline.size(); ++i) {
      vec2 lost{1e9, 1e9};
      for (const vec2 p : face) {
        const vec2 off = glm::abs(p - outline[i]);
        if (off.y == 0.0) lost.x = std::min(lost.x, off.x);
        if (off.x == 0.0) lost.y = std::min(lost.y, off.y);
      }
      ASSERT_GT(std::min(lost.x, lost.y), 0.0);
      ASSERT_GT(std::max(lost.x, lost.y), 2.0 * std::min(lost.x, lost.y));
      on_the_first += (lost.x > lost.y) == (i % 2 == 1) ? 1.0 : 0.0;
      count += 1.0;
    }
  }
  const auto p = [&](double share) {
    return support::chi_square_p({on_the_first, count - on_the_first}, {share * count, (1.0 - share) * count});
  };
  EXPECT_GT(p(0.5), support::significance());
  EXPECT_LT(p(0.55), support::significance()) << "the twin";
}

// The same tiles without a joint of their own: what moves there meets.
TEST(HandLaying, TwinWithoutRoomOverlaps) {
  Pavement paved = by_hand(type_of(Bond::running), 1.0, straight(20));
  const StoneLayout layout = laid_stones(by_hand(type_of(Bond::running), 0.0, straight(20)), 1);
  const double half = 0.5 * paved.joint_mm;
  const auto moved = [&](double room_mm) {
    StoneLayout result = layout;
    for (Stone& stone : result.stones) {
      stone.outline_mm = hand_face(stone.outline_mm, paved, room_mm, 1, Id("a").child(static_cast<std::uint64_t>(stone.id)));
    }
    return faults(paved, result);
  };
  EXPECT_EQ(moved(half - 0.01).total(), 0U);
  paved.joint_mm = 4.0 * paved.joint_mm;
  EXPECT_GT(moved(4.0 * half).overlaps, 100U);
}

// What photographs of old paving measure; and the twin of today's exactness, which all of them reject.
TEST(HandLaying, WornAlleyIsAsPhotographsAre) {
  for (const Bond bond : {Bond::packed, Bond::running, Bond::stack, Bond::herringbone, Bond::segmental_arc, Bond::fan}) {
    Pavement paved = by_hand(type_of(bond), 0.0, straight(20));
    const measure::HandFigures exact = measure::hand_figures(paved, laid_stones(paved, 3));
    paved.hand = hand_presets.back().hand;
    const measure::HandFigures worn = measure::hand_figures(paved, laid_stones(paved, 3));
    EXPECT_GT(worn.joint_ln_spread, 0.4);
    EXPECT_LT(worn.joint_ln_spread, 0.65);
    EXPECT_NEAR(worn.joint_median_percent, 100.0, 15.0);
    EXPECT_GT(worn.side_spread_percent, 12.0);
    EXPECT_LT(worn.side_spread_percent, 22.0);
    EXPECT_GT(worn.aspect_p90, 1.3);
    EXPECT_LT(worn.aspect_p90, 1.6);
    EXPECT_GT(worn.narrowest_mm, 0.02 * paved.joint_mm);
    EXPECT_LT(exact.joint_ln_spread, 0.1);
    EXPECT_LT(exact.side_spread_percent, 11.0);
    EXPECT_LT(exact.aspect_p90, 1.3);
  }
}

TEST(HandLaying, GoesFromNothingToAll) {
  double last = -1.0;
  for (const double amount : {0.0, 0.25, 0.5, 1.0}) {
    const Pavement paved = by_hand(type_of(Bond::running), amount, straight(0));
    const double spread = measure::hand_figures(paved, laid_stones(paved, 5)).joint_ln_spread;
    EXPECT_GT(spread, last);
    last = spread + 0.05;
  }
  Pavement paved = by_hand(type_of(Bond::running), 0.0, straight(0));
  const StoneLayout exact = laid_stones(paved, 5);
  paved.hand.rounded = 0.2;  // means nothing without an amount
  EXPECT_EQ(laid_stones(paved, 5), exact);
}

// Tiles cover what they covered: their areas add up to the same, and none lies over another.
TEST(HandLaying, TilesStillTile) {
  for (const Bond bond : {Bond::running, Bond::herringbone, Bond::hexagon, Bond::segmental_arc, Bond::fan, Bond::chevron}) {
    const Pavement paved = by_hand(type_of(bond), 1.0, straight(20));
    const geometry::RegionIndex area(paved.area);
    const std::vector<Tile> tiles = bond_tiles(paved, area, 1);
    const std::vector<Tile> moved = hand_set(tiles, 1.0, 1, Id("p"));
    ASSERT_EQ(moved.size(), tiles.size());
    double before = 0.0;
    double after = 0.0;
    std::size_t differ = 0;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
      before += geometry::area(tiles[t].outline_mm);
      after += geometry::area(moved[t].outline_mm);
      if (std::abs(geometry::area(moved[t].outline_mm) / geometry::area(tiles[t].outline_mm) - 1.0) > 0.02) ++differ;
    }
    EXPECT_NEAR(after / before, 1.0, 2e-5);  // sides that bend by less than 3 µm are straight
    EXPECT_GT(differ, tiles.size() / 2);
  }
}

TEST(HandLaying, HollowsAreTold) {
  Pavement paved = by_hand(type_of(Bond::running), 0.5, straight(0));
  paved.hand.sunk = 0.1;
  paved.hand.sunk_mm = 20.0;
  paved.variation.missing = 0.05;
  const StoneLayout layout = laid_stones(paved, 5);
  const auto laid = static_cast<double>(layout.stones.size() + layout.missing.size());
  EXPECT_NEAR(static_cast<double>(layout.missing.size()) / laid, 0.05, 0.02);
  const auto sunk = std::ranges::count_if(layout.stones, [](const Stone& stone) { return stone.sunk_mm > 0.0; });
  EXPECT_NEAR(static_cast<double>(sunk) / laid, 0.1, 0.03);
  for (const Stone& stone : layout.stones) EXPECT_LE(stone.sunk_mm, 20.0);
}

// All plazas that the project is tried on.
TEST(HandLaying, PlazasAreExact) {
  SKIP_WITHOUT_SHARED_DATA();
  for (const char* name : {"karl-marx-platz-berlin", "tabard-piazza-london", "footway-london"}) {
    const auto file = support::shared_data() / "plazas" / (std::string(name) + ".geojson");
    const geometry::Region area = scene::areas_of_file(file).front();
    for (const Direction& direction : {straight(30), Direction(BoundaryDirection{})}) {
      Pavement paved = pavement(area, 300, 12, direction);
      paved.hand = hand_presets.back().hand;
      paved.border.course = BorderCourse::stretcher;
      EXPECT_EQ(faults(paved, laid_stones(paved, 7)).total(), 0U) << name;
    }
  }
}

}  // namespace
}  // namespace shatterpave::paving
