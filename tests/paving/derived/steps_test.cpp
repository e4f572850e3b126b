#include "paving/derived/steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "geometry/clip.h"
#include "geometry/region_index.h"
#include "paving/catalogue/finishes.h"
#include "paving/laying.h"
#include "paving/layout_quality.h"
#include "paving/patch_seams.h"
#include "paving/paved_areas.h"
#include "paving/surface/stone_surface.h"

namespace shatterpave::paving {
namespace {

Pavement flight_of_steps(geometry::Region area, Direction direction, const Flight& flight) {
  Pavement result = pavement(std::move(area), 300.0, 5.0, std::move(direction));
  result.bonding.bond = Bond::running;
  result.stone_mm = {700.0, 300.0};
  result.flight = flight;
  return result;
}

const geometry::Region flight_area{{{0, 0}, {3000, 0}, {3000, 2800}, {0, 2800}}, {}};

double total(const std::vector<Pavement>& parts) {
  return std::accumulate(parts.begin(), parts.end(), 0.0,
                         [](double sum, const Pavement& part) { return sum + geometry::area(part.area); });
}

// Of the faces of its stones.
double level_mm(const Pavement& step) { return step.ground.level_mm + face_mm(step); }

TEST(Steps, TileTheAreaAndRiseByOneRiserEach) {
  const Flight flight{150.0, 350.0};
  for (const Finish finish : {Finish::none, Finish::split, Finish::flat_sawn}) {
    Pavement whole = flight_of_steps(flight_area, straight(0), flight);
    if (finish != Finish::none) whole.body = preset_of(finish).body;
    whole.ground.level_mm = 40.0;
    const std::vector<Pavement> parts = steps(whole);
    ASSERT_EQ(parts.size(), 8U);
    EXPECT_NEAR(total(parts), geometry::area(flight_area), 1.0);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const geometry::Box box = geometry::bounding_box(parts[k].area.outline);
      EXPECT_NEAR(box.low.y, 350.0 * static_cast<double>(k), 0.002);
      EXPECT_NEAR(box.high.y, 350.0 * static_cast<double>(k + 1), 0.002);
      EXPECT_NEAR(level_mm(parts[k]), level_mm(whole) + 150.0 * static_cast<double>(k + 1), 1e-9);
      // Its bed lies on the faces of the step below, and what stands below it reaches down to the ground.
      const double bed = parts[k].ground.level_mm + bed_level_mm(parts[k]);
      EXPECT_NEAR(bed, level_mm(parts[k]) - 150.0, 1e-9);
      EXPECT_NEAR(parts[k].ground.level_mm - parts[k].ground.depth_mm, parts[0].ground.level_mm - parts[0].ground.depth_mm,
                  1e-9);
    }
  }
}

TEST(Steps, AreOneRowOfBlocksEachWithJointsThatDoNotMeet) {
  const std::vector<Pavement> parts = steps(flight_of_steps(flight_area, straight(0), {150.0, 350.0}));
  std::vector<double> joints_before;
  for (const Pavement& step : parts) {
    const StoneLayout layout = laid_stones(step, 7);
    EXPECT_EQ(faults(step, layout).total(), 0U);
    EXPECT_GE(layout.stones.size(), 4U);
    EXPECT_LE(layout.stones.size(), 6U);
    std::vector<double> joints;
    for (const Stone& stone : layout.stones) {
      const geometry::Box box = geometry::bounding_box(stone.outline_mm);
      EXPECT_NEAR(box.high.y - box.low.y, 345.0, 0.01) << "as deep as a tread less the joint";
      if (box.high.x < 2990.0) joints.push_back(box.high.x);
    }
    for (const double joint : joints) {
      for (const double before : joints_before) EXPECT_GT(std::abs(joint - before), 100.0);
    }
    joints_before = joints;
  }
}

TEST(Steps, GoDownWhereTheRiserIsNegative) {
  const Pavement whole = flight_of_steps(flight_area, straight(0), {-150.0, 350.0});
  const std::vector<Pavement> parts = steps(whole);
  ASSERT_EQ(parts.size(), 8U);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    EXPECT_NEAR(level_mm(parts[k]), level_mm(whole) - 150.0 * static_cast<double>(k + 1), 1e-9);
    EXPECT_NEAR(parts[k].surface.height_mm, 150.0, 1e-9);
    EXPECT_NEAR(parts[k].ground.level_mm - parts[k].ground.depth_mm,
                parts.back().ground.level_mm - parts.back().ground.depth_mm, 1e-9);
    EXPECT_GE(parts[k].ground.depth_mm, 50.0);
  }
}

// What is left over is a narrower step, unless it is next to nothing.
TEST(Steps, EndWithANarrowerOne) {
  const auto depths = [](double tread_mm) {
    std::vector<double> result;
    for (const Pavement& step : steps(flight_of_steps(flight_area, straight(0), {150.0, tread_mm}))) {
      const geometry::Box box = geometry::bounding_box(step.area.outline);
      result.push_back(box.high.y - box.low.y);
    }
    return result;
  };
  const std::vector<double> narrower = depths(400.0 / 0.9);
  ASSERT_EQ(narrower.size(), 7U);
  EXPECT_NEAR(narrower.back(), 2800.0 - 6.0 * 400.0 / 0.9, 0.01);
  const std::vector<double> joined = depths(399.0);
  ASSERT_EQ(joined.size(), 7U);
  EXPECT_NEAR(joined.back(), 399.0 + 7.0, 0.01) << "7 mm are no step";
}

// In circles, along guides and along the outline: no stone leaves its step, and steps are covered but for joints.
TEST(Steps, FollowTheDirection) {
  GuidesDirection guides;
  guides.guides_mm = {{{0, -300}, {1500, 0}, {3000, -300}}};
  for (const Direction& direction :
       {straight(17), Direction(RadialDirection{{1500, -900}}), Direction(guides), Direction(BoundaryDirection{})}) {
    const std::vector<Pavement> parts = steps(flight_of_steps(flight_area, direction, {140.0, 350.0}));
    EXPECT_NEAR(total(parts), geometry::area(flight_area), 100.0);
    double stones = 0.0;
    for (const Pavement& step : parts) {
      const StoneLayout layout = laid_stones(step, 7);
      EXPECT_EQ(faults(step, layout).total(), 0U);
      for (const Stone& stone : layout.stones) stones += geometry::area(stone.outline_mm);
    }
    EXPECT_GT(stones, 0.95 * geometry::area(flight_area)) << direction.index();
    EXPECT_LT(stones, geometry::area(flight_area));
  }
}

// However deep the treads and long the stones, and however small what is left in corners: no step is bare.
TEST(Steps, AreNeverBare) {
  const geometry::Region square{{{0, 0}, {3000, 0}, {3000, 3000}, {0, 3000}}, {}};
  GuidesDirection across;
  across.guides_mm = {{{0, 0}, {3000, 3000}}};
  for (const Direction& direction :
       {straight(0), Direction(RadialDirection{{1500, 1500}}), Direction(across), Direction(BoundaryDirection{})}) {
    for (const double tread_mm : {350.0, 2200.0, 100'000.0}) {
      for (const double length_mm : {600.0, 50'000.0}) {
        Pavement whole = flight_of_steps(square, direction, {150.0, tread_mm});
        whole.stone_mm.x = length_mm;
        double stones = 0.0;
        for (const Pavement& step : steps(whole)) {
          const StoneLayout layout = laid_stones(step, 7);
          EXPECT_EQ(faults(step, layout).total(), 0U);
          if (geometry::area(step.area) > 2500.0) {
            EXPECT_FALSE(layout.stones.empty()) << direction.index() << ' ' << tread_mm << ' ' << length_mm;
          }
          for (const Stone& stone : layout.stones) stones += geometry::area(stone.outline_mm);
        }
        EXPECT_GT(stones, 0.93 * 9e6) << direction.index() << ' ' << tread_mm << ' ' << length_mm;
      }
    }
  }
}

TEST(Steps, InCirclesBeginAtTheNearestPoint) {
  const std::vector<Pavement> parts = steps(flight_of_steps(flight_area, RadialDirection{{1500, -900}}, {140.0, 350.0}));
  for (std::size_t k = 0; k < 3; ++k) {
    for (const vec2& p : parts[k].area.outline) {
      const double away = glm::length(p - vec2{1500, -900}) - 900.0;
      EXPECT_GE(away, 350.0 * static_cast<double>(k) - 2.0);
      EXPECT_LE(away, 350.0 * static_cast<double>(k + 1) + 2.0);
    }
  }
}

TEST(Steps, OfAPodiumAreRings) {
  const std::vector<Pavement> parts = steps(flight_of_steps(flight_area, BoundaryDirection{}, {140.0, 350.0}));
  ASSERT_EQ(parts.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    const double in = 350.0 * static_cast<double>(k);
    const geometry::Box box = geometry::bounding_box(parts[k].area.outline);
    EXPECT_NEAR(box.low.x, in, 0.01);
    EXPECT_NEAR(box.high.y, 2800.0 - in, 0.01);
    EXPECT_EQ(parts[k].area.holes.size(), k < 3 ? 1U : 0U);
  }
}

// The blocks' sides are seen: they are steep, reach the bed, and meet the arris without a gap, chips or not.
TEST(Steps, BlocksHaveSteepSides) {
  Pavement whole = flight_of_steps(flight_area, straight(0), {150.0, 350.0});
  whole.body = preset_of(Finish::split).body;
  whole.body.chips_per_m = 6.0;
  const Pavement step = steps(whole).front();
  for (const Stone& stone : laid_stones(step, 7).stones) {
    const StoneDraws draws = stone_draws(step, 7, stone.id);
    ASSERT_TRUE(draws.body);
    EXPECT_GT(draws.body->flank_mm, 120.0);
    const std::vector<geometry::BezierPatch> patches = surface_patches(stone.outline_mm, draws);
    const SeamErrors errors = seam_errors(patches);
    EXPECT_LT(errors.distance_mm, 1e-9);
    // A millimetre inside of the outline the body is within an arris of its face's height.
    double lowest = 1e9;
    for (const geometry::BezierPatch& patch : patches) {
      for (const vec3& p : patch.control_points) {
        const vec2 at{p.x, p.y};
        const geometry::RegionIndex index({stone.outline_mm, {}});
        if (index.nearest(at).distance_mm > 1.0) lowest = std::min(lowest, p.z);
      }
    }
    EXPECT_GT(lowest, draws.body->flank_mm - draws.sink_mm - 10.0);
  }
}

}  // namespace
}  // namespace shatterpave::paving
