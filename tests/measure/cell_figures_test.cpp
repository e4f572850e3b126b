#include "measure/cell_figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "measure/pavement_measures.h"
#include "paving/laying.h"

namespace shatterpave::measure {
namespace {

using geometry::Polygon;

Polygon square(vec2 middle, double side_mm, double degrees) {
  Polygon result;
  for (const vec2 corner : {vec2{-0.5, -0.5}, vec2{0.5, -0.5}, vec2{0.5, 0.5}, vec2{-0.5, 0.5}}) {
    result.push_back(middle + side_mm * rotated(corner, Angle::degrees(degrees)));
  }
  return result;
}

paving::Pavement paved(double degrees) {
  paving::Pavement pavement;
  pavement.name = "p";
  pavement.area = {{{0, 0}, {4000, 0}, {4000, 3000}, {0, 3000}}, {}};
  pavement.direction = paving::ConstantDirection{Angle::degrees(degrees)};
  return pavement;
}

CellFigures figures_of(const std::vector<Polygon>& outlines, double field_deg) {
  const paving::Pavement pavement = paved(field_deg);
  std::vector<InnerCell> cells;
  for (const Polygon& outline : outlines) cells.push_back({&outline, 4});
  return cell_figures(cells, paving::DirectionField(pavement, geometry::RegionIndex(pavement.area)));
}

TEST(CellFigures, OrderIsThatOfTheFieldAndNotOfThePlane) {
  EXPECT_NEAR(figures_of({square({0, 0}, 10, 30), square({20, 0}, 10, 30)}, 30).order, 1.0, 1e-9);
  EXPECT_NEAR(figures_of({square({0, 0}, 10, 30)}, 120).order, 1.0, 1e-9);  // a quarter turn on
  EXPECT_NEAR(figures_of({square({0, 0}, 10, 30)}, 75).order, -1.0, 1e-9);  // on its corner
  EXPECT_NEAR(figures_of({square({0, 0}, 10, 30)}, 30 + 22.5).order, 0.0, 1e-9);
  // By length of sides: of a square of 10 and one of 30 at 45° to it.
  EXPECT_NEAR(figures_of({square({0, 0}, 10, 0), square({50, 0}, 30, 45)}, 0).order, 0.25 - 0.75, 1e-9);
  // Cells that lie any way: 1000 cosines, standard deviation of their mean √(1/2) / √1000.
  std::vector<Polygon> any;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    any.push_back(square({20.0 * i, 0}, 10, 90.0 * uniform(1, {Stream::stone_place, Id("any"), i})));
  }
  EXPECT_LT(std::abs(figures_of(any, 0).order), 4.0 * std::sqrt(0.5 / 1000.0));
}

TEST(CellFigures, AreasAreToldByTheirMedianAndRelativeSpread) {
  const double e = std::exp(1.0);
  // Sides 10, 10·√e, 10·e: logarithms of areas 1 apart, whatever the unit.
  for (const double unit : {1.0, 7.0}) {
    const CellFigures f = figures_of(
        {square({0, 0}, 10 * unit, 0), square({500, 0}, 10 * unit * std::sqrt(e), 0), square({900, 0}, 10 * unit * e, 0)}, 0);
    EXPECT_NEAR(f.area_median_mm2, 100.0 * unit * unit * e, 1e-6 * unit * unit * 100.0);
    EXPECT_NEAR(f.area_ln_spread, 1.0, 1e-9);
  }
}

TEST(CellFigures, NeighboursOfASquarePackingAreFour) {
  const paving::Pavement plain = paved(0);
  const paving::StoneLayout layout = paving::laid_stones(plain, 1);
  const CellFigures f = measured(plain, layout, layout).figures.cells;
  EXPECT_GT(f.counted, 500U);
  EXPECT_EQ(f.neighbours_mean, 4.0);
  EXPECT_EQ(f.four_percent, 100.0);
  EXPECT_NEAR(f.area_ln_spread, 0.0, 1e-6);
  EXPECT_NEAR(f.order, 1.0, 1e-6);
  // A twin with sizes that follow a line has cells with five and six, whose areas differ.
  paving::Pavement sized = plain;
  sized.sizes = paving::SizesFromLines{{0.6, 1.6, 1500.0}, {{{0, 0}, {4000, 0}}}};
  const paving::StoneLayout other = paving::laid_stones(sized, 1);
  const CellFigures g = measured(sized, other, other).figures.cells;
  EXPECT_LT(g.four_percent, 99.0);
  EXPECT_GT(g.five_percent, 0.5);
  EXPECT_GT(g.area_ln_spread, 0.3);
  EXPECT_GT(g.order, 0.9);
}

}  // namespace
}  // namespace shatterpave::measure
