#include "paving/tiles/variation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/region_index.h"
#include "paving/bonds/bond.h"
#include "paving/bonds/table.h"
#include "paving/laying.h"
#include "paving/layout_quality.h"
#include "paving/paved_areas.h"
#include "paving/surface/stone_surface.h"

namespace shatterpave::paving {
namespace {

Pavement plain(double joint_mm) { return pavement(concave_area(), 100, joint_mm, ConstantDirection{Angle::degrees(20)}); }

TEST(Variation, NeverLetsStonesTouchOrLeaveTheArea) {
  for (const double joint_mm : {0.0, 2.0, 12.0}) {
    for (const BondType* type : bond_types()) {
      if (!type->is_for_scenes) continue;
      Pavement paved = plain(joint_mm);
      paved.bonding.bond = type->id;
      paved.variation = {0.3, Angle::degrees(20), 30.0, 5.0, 0.02, {}};
      EXPECT_EQ(faults(paved, laid_stones(paved, 3)).total(), 0U) << joint_mm;
    }
  }
  // Without the limit they would: the same movement that takes all of a wide joint, where the joint is narrow.
  Pavement paved = plain(2.0);
  const StoneLayout layout = laid_stones(paved, 3);
  paved.joint_mm = 12.0;
  paved.variation.offset_mm = 30.0;
  const StoneLayout loose = varied(layout, {}, paved, side_bulge(paved), 3);
  paved.joint_mm = 2.0;
  EXPECT_GT(faults(paved, loose).overlaps, 100U);
}

// Between the two of all pairs of stones nearest to one another, mm.
double narrowest_joint(const StoneLayout& layout) {
  double narrowest = 1e300;
  for (const Stone& one : layout.stones) {
    const geometry::Box box = geometry::bounding_box(one.outline_mm);
    for (const Stone& other : layout.stones) {
      const geometry::Box beside = geometry::bounding_box(other.outline_mm);
      const vec2 apart = glm::max(beside.low - box.high, box.low - beside.high);
      if (one.id == other.id || std::max(apart.x, apart.y) > narrowest) continue;
      for (const vec2& p : one.outline_mm) {
        for (std::size_t i = 0; i < other.outline_mm.size(); ++i) {
          const vec2 q = other.outline_mm[i];
          const vec2 nearest = geometry::nearest_point({q, other.outline_mm[(i + 1) % other.outline_mm.size()]}, p);
          narrowest = std::min(narrowest, glm::length(nearest - p));
        }
      }
    }
  }
  return narrowest;
}

// On a bend a straight side may be nearer to its neighbours than the joint (cells.h), which takes from what corners may move.
TEST(Variation, NeverLetsStonesTouchWhereRowsBend) {
  for (const Direction& direction : {Direction{RadialDirection{{1700, 2600}}}, Direction{BoundaryDirection{}}}) {
    for (const vec2 stone_mm : {vec2{100, 100}, vec2{140, 90}}) {
      Pavement paved = plain(8.0);
      paved.direction = direction;
      paved.stone_mm = stone_mm;
      const StoneLayout layout = laid_stones(paved, 3);
      paved.variation = {0.3, Angle::degrees(20), 30.0, 0.0, 0.0, {}};
      EXPECT_EQ(faults(paved, varied(layout, {}, paved, side_bulge(paved), 3)).total(), 0U);
      // Each of two neighbours may move by 0.3 of the joint. By half of it, as where rows are straight, would be too much.
      EXPECT_GE(narrowest_joint(layout), 0.6 * paved.joint_mm);
      EXPECT_LT(narrowest_joint(layout), 0.9 * paved.joint_mm);
    }
  }
}

TEST(Variation, EachKindMovesStonesAsAsked) {
  const StoneLayout layout = laid_stones(plain(20.0), 3);
  const auto changed = [&](const Variation& variation) {
    Pavement paved = plain(20.0);
    paved.variation = variation;
    return varied(layout, {}, paved, side_bulge(paved), 3);
  };
  const StoneLayout sized = changed({0.04, {}, 0.0, 0.0, 0.0, {}});
  const StoneLayout turned = changed({0.0, Angle::degrees(3), 0.0, 0.0, 0.0, {}});
  const StoneLayout shifted = changed({0.0, {}, 5.0, 0.0, 0.0, {}});
  double largest = 0.0;
  double smallest = 2.0;
  double turn = 0.0;
  double shift = 0.0;
  for (std::size_t s = 0; s < layout.stones.size(); ++s) {
    const auto& before = layout.stones[s].outline_mm;
    const double scale = std::sqrt(geometry::area(sized.stones[s].outline_mm) / geometry::area(before));
    largest = std::max(largest, scale);
    smallest = std::min(smallest, scale);
    const auto& after = turned.stones[s].outline_mm;
    EXPECT_NEAR(geometry::area(after), geometry::area(before), 0.002 * geometry::area(before));
    turn = std::max(turn, std::abs(Angle::of(after[1] - after[0]).degrees() - Angle::of(before[1] - before[0]).degrees()));
    const vec2 step = geometry::centroid(shifted.stones[s].outline_mm) - geometry::centroid(before);
    shift = std::max({shift, std::abs(step.x), std::abs(step.y)});
  }
  EXPECT_NEAR(largest, 1.04, 0.001);
  EXPECT_NEAR(smallest, 0.96, 0.001);
  EXPECT_NEAR(shift, 5.0, 0.05);
  EXPECT_GT(turn, 2.9);
}

TEST(Variation, MissingStonesLeaveTheOthersAndTheirIds) {
  Pavement paved = plain(8.0);
  const StoneLayout whole = laid_stones(paved, 3);
  paved.variation.missing = 0.1;
  const StoneLayout holed = laid_stones(paved, 3);
  const auto count = static_cast<double>(whole.stones.size());
  EXPECT_NEAR(static_cast<double>(holed.stones.size()) / count, 0.9, 4.0 * std::sqrt(0.09 / count));
  for (const Stone& stone : holed.stones) EXPECT_EQ(stone, whole.stones[static_cast<std::size_t>(stone.id)]);
  EXPECT_LT(quality(paved, holed).coverage, 0.93);
  paved.variation.missing = 1.0;
  EXPECT_TRUE(laid_stones(paved, 3).stones.empty());
}

TEST(Variation, SunkenStonesLieLowerByTheirDraw) {
  Pavement paved = plain(8.0);
  paved.variation.sink_mm = 6.0;
  const geometry::Polygon outline{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  double lowest = 0.0;
  for (int id = 0; id < 200; ++id) {
    const StoneDraws draws = stone_draws(paved, 3, id);
    StoneDraws level = draws;
    level.sink_mm = 0.0;
    EXPECT_NEAR(surface_patches(outline, level)[0].at(1, 1).z - surface_patches(outline, draws)[0].at(1, 1).z, draws.sink_mm,
                1e-9);
    lowest = std::max(lowest, draws.sink_mm);
  }
  EXPECT_GT(lowest, 5.5);
  EXPECT_LE(lowest, 6.0);
}

}  // namespace
}  // namespace shatterpave::paving
