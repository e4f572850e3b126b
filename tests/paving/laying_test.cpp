#include "paving/laying.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/lattice.h"
#include "paving/layout_quality.h"
#include "paving/paved_areas.h"
#include "paving/tiles/cutting.h"
#include "scene/plans/plan_areas.h"
#include "support/shared_data.h"

namespace shatterpave::paving {
namespace {

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
      // Few are smaller than a quarter: only where no two stones that fit their stock can be made of one and a neighbour.
      const auto small = std::ranges::count_if(
          layout.stones, [](const Stone& stone) { return geometry::area(stone.outline_mm) < least_piece * 100.0 * 100.0; });
      EXPECT_LE(small, 2) << degrees;
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

// What the design of the paving holds the packing to, on its benchmark.
TEST(Laying, RadialRowsOnTheQuarterAnnulusMeetTheirTargets) {
  for (const double stone_mm : {248.0, 89.0}) {
    const Pavement paved = pavement(quarter_annulus(), stone_mm, 8, RadialDirection{});
    const StoneLayout layout = laid_stones(paved, 7);
    EXPECT_EQ(faults(paved, layout).total(), 0U);
    const LayoutQuality q = quality(paved, layout);
    EXPECT_GT(q.stones, stone_mm > 100 ? 900U : 6500U);
    EXPECT_GT(q.whole, q.stones * 9 / 10);
    EXPECT_LE(q.mean_misalignment_deg, 1.5);
    EXPECT_LE(q.p95_misalignment_deg, 5.0);
    EXPECT_GE(q.four_sided, 0.98);
    EXPECT_GE(q.coverage, 0.995);
    EXPECT_GE(q.joint_p5, 0.9);
    EXPECT_LE(q.joint_p95, 1.1);
    EXPECT_LE(q.area_spread, 0.08);
    EXPECT_GE(q.smallest, least_piece);
  }
}

struct FieldCase {
  const char* name;
  Direction direction;
};

class LayingAlongEveryField : public testing::TestWithParam<FieldCase> {};

TEST_P(LayingAlongEveryField, IsExactAndWithoutHoles) {
  for (const geometry::Region& area : {path_area(), concave_area()}) {
    for (const vec2 stone_mm : {vec2{100, 100}, vec2{140, 90}}) {
      Pavement paved = pavement(area, 100, 8, GetParam().direction);
      paved.stone_mm = stone_mm;
      const StoneLayout layout = laid_stones(paved, 7);
      EXPECT_EQ(faults(paved, layout).total(), 0U);
      const LayoutQuality q = quality(paved, layout);
      EXPECT_GE(q.coverage, 0.995);
      EXPECT_GT(q.whole, q.stones / 2);
      EXPECT_GE(q.four_sided, 0.98);
      EXPECT_LE(q.mean_misalignment_deg, 3.0);
      EXPECT_NEAR(q.mean_area, 1.0, 0.05);
      for (const Stone& stone : layout.stones) {
        EXPECT_GT(stone.angle.degrees(), -90.0);
        EXPECT_LE(stone.angle.degrees(), 90.0);
      }
    }
  }
}

// Where guides end, rows bend within a stone's length and all that is irregular comes together. Without the wish for areas they
// spread by 10 to 11 % here, and where a corner of four stones took the fourth corner of one, this was a triangle beside a
// stone of nearly double size.
TEST(Laying, OblongStonesBesideEndsOfGuidesAreAlikeAndNoTriangles) {
  for (const std::uint64_t seed : {1U, 2U, 7U}) {
    Pavement paved = pavement({{{0, 0}, {5000, 0}, {5000, 5000}, {0, 5000}}, {}}, 100, 8,
                              GuidesDirection{{{{-500, 750}, {2000, 1500}, {3250, 3500}}, {{250, 5500}, {1500, 3750}}}});
    paved.stone_mm = {140, 90};
    const StoneLayout layout = laid_stones(paved, seed);
    const LayoutQuality q = quality(paved, layout);
    EXPECT_LE(q.area_spread, 0.085) << seed;
    EXPECT_LE(q.mean_misalignment_deg, 1.5) << seed;
    EXPECT_LE(q.p95_misalignment_deg, 5.0) << seed;
    for (const Stone& stone : layout.stones) {
      EXPECT_TRUE(stone.kind != StoneKind::whole || stone.outline_mm.size() >= 4) << seed << ", stone " << stone.id;
    }
  }
}

TEST(Laying, OblongStonesAlongTheSidesOfASquareAreExactButForTheirMitres) {
  Pavement paved = pavement({{{0, 0}, {5000, 0}, {5000, 5000}, {0, 5000}}, {}}, 100, 8, BoundaryDirection{});
  paved.stone_mm = {140, 90};
  const StoneLayout layout = laid_stones(paved, 7);
  EXPECT_EQ(faults(paved, layout).total(), 0U);
  const LayoutQuality q = quality(paved, layout);
  EXPECT_LT(q.p95_misalignment_deg, 0.01);
  EXPECT_EQ(q.four_sided, 1.0);
  EXPECT_LT(q.area_spread, 0.001);
  EXPECT_GE(q.coverage, 0.995);
  EXPECT_GE(q.smallest, least_piece);
  // Four mitres of 3.5 m, each through 36 rows from either side: two cut stones a row at the most.
  EXPECT_GT(q.whole, q.stones - 4 * 36 * 2);
}

INSTANTIATE_TEST_SUITE_P(Fields, LayingAlongEveryField,
                         testing::Values(FieldCase{"constant", straight(20)}, FieldCase{"boundary", BoundaryDirection{}},
                                         FieldCase{"radial", RadialDirection{{2000, -800}}},
                                         FieldCase{"guides", GuidesDirection{{{{-500, -500}, {2000, 600}, {4000, 1800}},
                                                                              {{0, 6000}, {2500, 4200}}}}}),
                         [](const auto& named) { return std::string(named.param.name); });

TEST(Laying, IsTheSameWithAnyNumberOfThreads) {
  const Pavement paved = pavement(concave_area(), 100, 8, BoundaryDirection{});
  std::vector<StoneLayout> layouts;
  for (const int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    layouts.push_back(laid_stones(paved, 7));
  }
  EXPECT_EQ(layouts[0], layouts[1]);
  EXPECT_EQ(layouts[0], layouts[2]);
  EXPECT_NE(layouts[0], laid_stones(paved, 8));
}

// Real plans; 300 mm stones, so that the test is quick.
TEST(Laying, PlazasAreExactAlongTheirBorders) {
  SKIP_WITHOUT_SHARED_DATA();
  for (const char* name : {"karl-marx-platz-berlin", "tabard-piazza-london", "footway-london"}) {
    const auto file = support::shared_data() / "plazas" / (std::string(name) + ".geojson");
    const geometry::Region area = scene::areas_of_file(file).front();
    for (const Direction& direction : {straight(30), Direction(BoundaryDirection{})}) {
      const Pavement paved = pavement(area, 300, 8, direction);
      const StoneLayout layout = laid_stones(paved, 7);
      EXPECT_GT(layout.stones.size(), 1000U) << name;
      EXPECT_EQ(faults(paved, layout).total(), 0U) << name;
      const LayoutQuality q = quality(paved, layout);
      EXPECT_GE(q.coverage, 0.995) << name;
      EXPECT_GE(q.four_sided, 0.98) << name;
      EXPECT_GE(q.joint_p5, 0.9) << name;
      EXPECT_LE(q.joint_p95, 1.1) << name;
    }
  }
}

// Areas that leave no room for a plain stone. Nothing may crash, hang, overlap or leave the area.
TEST(Laying, BearsOddAreas) {
  const std::vector<geometry::Region> areas = {
      {{{0, 0}, {5000, 0}, {5000, 30}, {0, 30}}, {}},                            // thinner than a stone
      {{{0, 0}, {60, 0}, {60, 50}, {0, 50}}, {}},                                // smaller than a stone
      {{{0, 0}, {0.004, 0}, {0, 0.004}}, {}},                                    // smaller than the joint
      {{{0, 0}, {8000, 10}, {0, 20}}, {}},                                       // a needle
      {{{0, 0}, {3000, 0}, {1500, 3}, {3000, 900}, {0, 900}, {1400, 4}}, {}},    // waists
      {{{0, 0}, {900, 0}, {900, 900}, {0, 900}}, {circle({450, 450}, 20, 12)}},  // a hole within a stone
      {{{0, 0}, {900, 0}, {900, 900}, {0, 900}},
       {{{450, 450}, {450, 900}, {300, 600}},  // holes that touch all and sundry
        {{450, 450}, {600, 300}, {450, 300}}}},
  };
  for (const geometry::Region& area : areas) {
    for (const Direction& direction : {straight(10), Direction(BoundaryDirection{}), Direction(RadialDirection{{450, 450}})}) {
      for (const double joint_mm : {0.0, 8.0, 150.0}) {
        const Pavement paved = pavement(area, 100, joint_mm, direction);
        const LayoutFaults found = faults(paved, laid_stones(paved, 1));
        EXPECT_EQ(found.total(), 0U) << "area " << &area - areas.data() << ", joint " << joint_mm << ": " << found.invalid
                                     << " invalid, " << found.overlaps << " overlaps, " << found.outside << " outside";
      }
    }
  }
}

// A hole whose tip is narrower than the lattice, so that a stone of the border lost it when it was cut.
TEST(Laying, StaysOutsideANeedle) {
  const vec2 tip{-6252.954, 1379.166};
  Pavement paved = pavement(
      {{{-7083.728, -156.727}, {-6928.916, -112.814}, {-6761.130, 60.560},   {-6587.703, 355.817},  {-6416.214, 760.055},
        {-6254.159, 1255.606}, {-6108.619, 1820.811}, {-5985.957, 2430.970}, {-5891.532, 3059.413}, {-5829.472, 3678.677},
        {-5802.488, 4261.696}, {-5811.761, 4782.989}, {-5856.884, 5219.773}, {-5935.887, 5552.959}, {-6045.315, 5767.985},
        {-6180.387, 5855.453}, {-6088.781, 5774.516}, {-6020.920, 5565.735}, {-5979.768, 5238.237}, {-5967.124, 4806.332},
        {-5983.541, 4288.899}, {-6028.301, 3708.552}, {-6099.448, 3090.653}, {-6193.873, 2462.209}, {-6307.449, 1850.686},
        {-6435.212, 1282.810}, {-6571.577, 783.399},  {-6710.586, 374.281},  {-6846.163, 73.336},   {-6972.382, -106.283}},
       {{tip, {-6301.004, 1382.811}, {-6301.016, 1382.829}}}},
      71.7, 7.4, straight(45));
  paved.stone_mm.y = 30.4;
  paved.bonding.bond = Bond::stack;
  paved.border.course = BorderCourse::soldier;
  for (const Stone& stone : laid_stones(paved, 907).stones) EXPECT_FALSE(geometry::contains_strictly(stone.outline_mm, tip));
}

TEST(Laying, RefusesSizesThatMeanNothing) {
  const geometry::Region area = path_area();
  EXPECT_THROW(static_cast<void>(laid_stones(pavement(area, 0, 8, straight(0)), 1)), InputError);
  EXPECT_THROW(static_cast<void>(laid_stones(pavement(area, 100, -1, straight(0)), 1)), InputError);
  EXPECT_THROW(static_cast<void>(laid_stones(pavement(area, std::nan(""), 8, straight(0)), 1)), InputError);
  EXPECT_THROW(static_cast<void>(laid_stones(pavement({}, 100, 8, straight(0)), 1)), InputError);
  EXPECT_THROW(static_cast<void>(laid_stones(pavement(area, 100, 8, GuidesDirection{}), 1)), InputError);
}

TEST(Laying, WithoutJointsStonesStillDoNotMeet) {
  const Pavement paved = pavement(concave_area(), 100, 0, BoundaryDirection{});
  const StoneLayout layout = laid_stones(paved, 7);
  EXPECT_EQ(faults(paved, layout).total(), 0U);
  double laid = 0.0;
  for (const Stone& stone : layout.stones) laid += geometry::area(stone.outline_mm);
  EXPECT_GT(laid, 0.999 * geometry::area(paved.area));
}

// The oracle itself must see what is wrong.
TEST(LayoutOracle, SeesOverlapAndStonesOutside) {
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
