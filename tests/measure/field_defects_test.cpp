#include "measure/field_defects.h"

#include <gtest/gtest.h>

#include "core/functions.h"
#include "geometry/region_index.h"
#include "paving/packing/packing.h"
#include "paving/paved_areas.h"

namespace shatterpave::measure {
namespace {

FieldDefects defects(const paving::Pavement& pavement) {
  const geometry::RegionIndex area(pavement.area);
  return field_defects(pavement, paving::DirectionField(pavement, area), paving::SizeField(pavement, area), area);
}

geometry::Region square(double low, double high) { return {{{low, low}, {high, low}, {high, high}, {low, high}}, {}}; }

// (π / 2) (10 m − 4 m) / pitch = 9.42 m / pitch.
TEST(FieldDefects, OfCirclesFollowFromTheCircumference) {
  for (const double stone_mm : {248.0, 89.0, 21.6}) {
    const FieldDefects found = defects(paving::pavement(paving::quarter_annulus(), stone_mm, 8, paving::RadialDirection{}));
    const double expected = 0.5 * pi * 6000.0 / (stone_mm + 8.0);
    EXPECT_NEAR(found.row_bends, expected, 0.01 * expected);
    EXPECT_LT(found.column_bends, 0.001 * expected) << "radii are straight";
    EXPECT_EQ(found.singularities, 0U);
  }
}

TEST(FieldDefects, OfOblongStonesOnCirclesGoWithTheirLength) {
  paving::Pavement paved = paving::pavement(paving::quarter_annulus(), 100, 8, paving::RadialDirection{});
  paved.stone_mm = {200, 50};
  EXPECT_NEAR(defects(paved).least_spots(), 0.5 * pi * 6000.0 / 208.0, 0.5);
}

TEST(FieldDefects, AreNoneWhereTheFieldIsStraight) {
  EXPECT_NEAR(
      defects(paving::pavement(paving::concave_area(), 100, 8, paving::ConstantDirection{Angle::degrees(33)})).least_spots(),
      0.0, 1e-6);
  // Along a square's border a cross field is the square's own.
  EXPECT_NEAR(defects(paving::pavement(square(0, 3000), 100, 8, paving::BoundaryDirection{})).least_spots(), 0.0, 1e-6);
}

// Along a circle the field must turn once all round: four quarter turns, wherever they are.
TEST(FieldDefects, HaveFourQuarterTurnsWithinACircle) {
  const geometry::Region disc{paving::circle({0, 0}, 3000, 64), {}};
  EXPECT_EQ(defects(paving::pavement(disc, 100, 8, paving::RadialDirection{})).singularities, 4U);
  EXPECT_EQ(defects(paving::pavement(disc, 100, 8, paving::BoundaryDirection{})).singularities, 4U);
}

}  // namespace
}  // namespace shatterpave::measure
