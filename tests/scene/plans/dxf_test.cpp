// Drawings as an architect's program writes them are read by tests/scripts/dxf_test.sh; here are the smallest that show each
// rule.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "geometry/polygon.h"
#include "scene/plans/plan.h"
#include "scene/plans/plan_areas.h"

namespace shatterpave::scene {
namespace {

// Lines of a DXF parted by spaces, in a drawing in millimetres.
Plan drawing(std::string entities) {
  std::ranges::replace(entities, ' ', '\n');
  return plan_of_dxf(
      "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities +
          "\n0\nENDSEC\n0\nEOF\n",
      "a.dxf");
}

std::size_t count(const Plan& plan, ShapeKind kind) {
  return static_cast<std::size_t>(std::ranges::count(plan.shapes, kind, &PlanShape::kind));
}

double area_mm2(const Plan& plan, const ShapeChoice& choice = {}) {
  const auto shapes = chosen_shapes(plan, {ShapeKind::area}, choice, ByDefault::the_only_feature);
  double sum = 0.0;
  for (const geometry::Region& region : regions_of(plan, shapes, frame_of(plan, shapes, {}, {}), 0.0)) {
    sum += geometry::area(region.outline);
    for (const geometry::Polygon& hole : region.holes) sum -= std::abs(geometry::area(hole));
  }
  return sum;
}

const std::string court = "0 LWPOLYLINE 8 court 5 A1 90 4 70 1 10 0 20 0 10 100 20 0 10 100 20 80 10 0 20 80";
const std::string trees = " 0 LWPOLYLINE 8 trees 5 A2 90 3 70 1 10 10 20 10 10 20 20 10 10 20 20 20";

TEST(Dxf, ClosedLinesAreAreasOfTheirLayer) {
  EXPECT_NEAR(area_mm2(drawing(court)), 8000.0, 1e-9);
  const Plan plan = drawing(court + trees);
  ShapeChoice choice;
  choice.class_name = "trees";
  EXPECT_NEAR(area_mm2(plan, choice), 50.0, 1e-9);
  choice.class_name = "court";
  EXPECT_NEAR(area_mm2(plan, choice), 8000.0, 1e-9);
  // Each is a feature by its own handle, within that of its layer.
  for (const PlanShape& shape : plan.shapes) {
    ASSERT_LT(shape.feature, plan.features.size());
    const PlanFeature& feature = plan.features[shape.feature];
    ASSERT_TRUE(feature.group.has_value());
    EXPECT_EQ(feature.ids.front() == "A1", plan.features[*feature.group].ids.front() == "court");
  }
}

TEST(Dxf, LinesThatMeetAreAnOutline) {
  const std::string sides =
      "0 LINE 8 a 10 0 20 0 11 30 21 0 0 LINE 8 a 10 30 20 40 11 30 21 0 0 LINE 8 a 10 30 20 40 11 0 21 0";
  EXPECT_NEAR(area_mm2(drawing(sides)), 600.0, 1e-9);
}

// They stand at a point, which would be a tree or a lamp to a scene that asks for points. The text of a hatch names its
// pattern.
TEST(Dxf, WordsAreNoPoints) {
  const std::string point = " 0 POINT 8 a 10 5 20 5";
  const std::string words = " 0 TEXT 8 a 10 5 20 5 40 2 1 yard";
  const std::string told = " 0 TEXT 8 a 100 AcDbEntity 100 AcDbText 10 5 20 5 40 2 1 yard";
  EXPECT_EQ(count(drawing(court + point), ShapeKind::point), 1U);
  EXPECT_EQ(count(drawing(court + words), ShapeKind::point), 0U);
  EXPECT_EQ(count(drawing(court + told), ShapeKind::point), 0U);
  const std::string hatch =
      "0 HATCH 8 h 2 SOLID 70 1 71 0 91 1 92 3 72 0 73 1 93 3 10 0 20 0 10 9 20 0 10 9 20 9 97 0 75 0 76 1 98 0";
  EXPECT_NEAR(area_mm2(drawing(hatch)), 40.5, 1e-9);
}

}  // namespace
}  // namespace shatterpave::scene
