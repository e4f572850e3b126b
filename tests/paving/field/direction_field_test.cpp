#include "paving/field/direction_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "paving/paved_areas.h"

namespace shatterpave::paving {
namespace {

// The least angle between an axis and a direction in degrees, with quarter turns left out.
double off_by(vec2 axis, Angle direction) {
  const vec2 d = direction.direction();
  const double along = std::abs(glm::dot(axis, d));
  const double across = std::abs(cross(axis, d));
  return Angle::of({std::max(along, across), std::min(along, across)}).degrees();
}

DirectionField field_of(const Pavement& paved) { return {paved, geometry::RegionIndex(paved.area)}; }

TEST(DirectionField, ConstantAndRadialAreExact) {
  const auto constant = field_of(pavement(path_area(), 100, 8, ConstantDirection{Angle::degrees(33)}));
  EXPECT_NEAR(constant.angle({123, 456}).degrees(), 33.0, 1e-12);
  const auto radial = field_of(pavement(quarter_annulus(), 100, 8, RadialDirection{{100, 200}}));
  EXPECT_NEAR(radial.angle({100 + 300, 200}).degrees(), 90.0, 1e-12);
  EXPECT_NEAR(radial.angle({100 + 300, 200 + 300}).degrees(), -45.0, 1e-12);
  // The centre has no direction, but a value.
  EXPECT_EQ(glm::dot(radial.axis({100, 200}), radial.axis({100, 200})), 1.0);
}

// A singular place in the middle, as between the poles of a magnet; the field goes round it once.
TEST(DirectionField, AGridIsFollowedRoundASingularPlace) {
  GridDirection grid{{-1000.0, -1000.0}, 500.0, 5, {}};
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 5; ++column) grid.vectors.push_back({-(row - 2.0), column - 2.0});
  }
  const Pavement paved = pavement({{{-900, -900}, {900, -900}, {900, 900}, {-900, 900}}, {}}, 100, 8, grid);
  const auto field = field_of(paved);
  for (const vec2 place : {vec2{1000, 0}, vec2{0, 500}, vec2{-500, -500}, vec2{2000, 0}}) {
    EXPECT_LT(off_by(field.axis(place), Angle::of(left_of(place))), 1e-6);
  }
  EXPECT_NEAR(glm::length(field.axis({0, 0})), 1.0, 1e-12);
  // Between the vectors; the twin that takes the nearest one is off by 18° or more.
  EXPECT_LT(off_by(field.axis({750, 250}), Angle::of(left_of({750, 250}))), 6.0);
  Pavement broken = paved;
  std::get<GridDirection>(broken.direction).vectors.assign(25, vec2{0.0, 0.0});
  EXPECT_THROW(field_of(broken), InputError);
}

TEST(DirectionField, BoundaryRowsFollowTheNearestSide) {
  const auto field = field_of(pavement(concave_area(), 100, 8, BoundaryDirection{}));
  EXPECT_LT(off_by(field.axis({3000, 20}), Angle()), 1.0);
  EXPECT_LT(off_by(field.axis({5980, 1200}), Angle()), 1.0);
  EXPECT_LT(off_by(field.axis({1990, 5240}), Angle::of({-3000, 500})), 1.5);
  // Above the round hole.
  EXPECT_LT(off_by(field.axis({1700, 3220}), Angle()), 5.0);
}

TEST(DirectionField, BoundaryOfARectangleIsStraight) {
  const auto field = field_of(pavement({{{0, 0}, {3000, 0}, {3000, 2000}, {0, 2000}}, {}}, 100, 8, BoundaryDirection{}));
  for (double x = 0; x <= 3000; x += 300) {
    for (double y = 0; y <= 2000; y += 200) EXPECT_LT(off_by(field.axis({x, y}), Angle()), 0.01);
  }
}

TEST(DirectionField, GuidesAreFollowedAndInterpolated) {
  const GuidesDirection guides{{{{0, 100}, {4000, 100}}, {{0, 1100}, {4000, 1800}}}};
  const auto field = field_of(pavement(path_area(), 100, 8, guides));
  const double upper = Angle::of({4000, 700}).degrees();
  EXPECT_NEAR(field.angle({2000, 100}).degrees(), 0.0, 1.0);
  EXPECT_NEAR(field.angle({200, 1135}).degrees(), upper, 1.0);
  const double between = field.angle({2000, 775}).degrees();
  EXPECT_GT(between, 0.25 * upper);
  EXPECT_LT(between, 0.75 * upper);
}

TEST(DirectionField, OblongStonesTellRowsFromColumns) {
  Pavement paved = pavement({{{0, 0}, {3000, 0}, {3000, 3000}, {0, 3000}}, {}}, 100, 8, BoundaryDirection{});
  EXPECT_TRUE(field_of(paved).is_cross());
  paved.stone_mm = {200, 100};
  const auto field = field_of(paved);
  EXPECT_FALSE(field.is_cross());
  EXPECT_GT(std::abs(field.axis({1500, 30}).x), 0.99);
  EXPECT_GT(std::abs(field.axis({30, 1500}).y), 0.99);
}

}  // namespace
}  // namespace shatterpave::paving
