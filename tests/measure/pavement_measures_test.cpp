#include "measure/pavement_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "geometry/lattice.h"
#include "measure/coverage.h"
#include "measure/pavement_findings.h"
#include "paving/bonds/table.h"
#include "paving/laying.h"
#include "paving/paved_areas.h"

namespace shatterpave::measure {
namespace {

using paving::Pavement;
using paving::StoneLayout;

// 4 × 3 whole stones of 100 × 100 mm, joints of 8 mm, half of which stay free along the outline.
Pavement small_path(double angle_deg = 0.0) {
  return paving::pavement({{{0, 0}, {432, 0}, {432, 324}, {0, 324}}, {}}, 100, 8,
                          paving::ConstantDirection{Angle::degrees(angle_deg)});
}

Pavement annulus(double stone_mm) {
  return paving::pavement(paving::quarter_annulus(), stone_mm, 8, paving::RadialDirection{});
}

LayoutMeasures as_laid(const Pavement& pavement, const StoneLayout& layout) {
  return measure::measured(pavement, layout, layout);
}

std::vector<std::string> failing(const Pavement& pavement, const LayoutFigures& figures) {
  std::vector<std::string> ids;
  for (const Finding& finding : pavement_findings(pavement, {&figures, 1})) {
    if (finding.verdict == Verdict::fails) ids.emplace_back(finding.id);
  }
  return ids;
}

using Ids = std::vector<std::string>;

TEST(PavementMeasures, OfPlainRowsAreExact) {
  const Pavement path = small_path();
  const LayoutMeasures measures = as_laid(path, paving::laid_stones(path, 1));
  const LayoutFigures& f = measures.figures;
  EXPECT_EQ(f.stones, 12U);
  EXPECT_EQ(f.whole, 12U);
  EXPECT_EQ(f.faults.total(), 0U);
  EXPECT_EQ(f.sides, 48U);
  EXPECT_EQ(f.misaligned_mean_deg, 0.0);
  EXPECT_EQ(f.four_sided_percent, 100.0);
  EXPECT_EQ(f.covered_percent, 100.0);
  EXPECT_EQ(f.joints, 34U) << "17 joints, from either side";
  EXPECT_NEAR(f.joint_p5_percent, 100.0, 1e-9);
  EXPECT_NEAR(f.joint_p95_percent, 100.0, 1e-9);
  EXPECT_EQ(f.area_mean_percent, 100.0);
  EXPECT_EQ(f.area_spread_percent, 0.0);
  EXPECT_EQ(f.smallest_percent, 100.0);
  EXPECT_EQ(f.irregular_spots, 0U);
  EXPECT_EQ(f.field.least_spots(), 0.0);
  EXPECT_EQ(failing(path, f), Ids{});
}

TEST(PavementMeasures, TellWhatIsOffByHowMuch) {
  const Pavement path = small_path();
  StoneLayout layout = paving::laid_stones(path, 1);
  // The first stone, half as high, and its right side leaning by 0.1: 5.71° over 50.249 mm of 305.249 mm.
  layout.stones[0].outline_mm = {{4, 4}, {99, 4}, {104, 54}, {4, 54}};
  const LayoutMeasures measures = as_laid(path, layout);
  const StoneMeasures& first = measures.stones[0];
  EXPECT_NEAR(first.area_ratio, 0.4875, 1e-12);
  const double lean = std::sqrt(50.0 * 50.0 + 5.0 * 5.0);
  EXPECT_NEAR(*first.misaligned_deg, 5.7105931 * lean / (95 + 100 + 50 + lean), 1e-6);
  EXPECT_EQ(first.joint_ratio.count(), 1U) << "the stone above is too far away";
  EXPECT_NEAR(first.joint_ratio.mean(), (8.0 + 0.6 * 5.0) / 8.0, 0.01) << "straight out from 0.4 of the leaning side";
  EXPECT_NEAR(measures.figures.smallest_percent, 48.75, 1e-9);
  EXPECT_EQ(measures.figures.holes, 1U);
  // 50 × 100 mm above it and the wedge beside it, of 432 × 324 mm.
  EXPECT_NEAR(measures.figures.covered_percent, 100.0 * (1.0 - (50.0 * 108.0 + 125.0) / (432.0 * 324.0)), 0.15);
}

// The three faults that the scorer must reject, each by a finding of its own; the layout without them must hold.
class GoodLayout : public testing::Test {
 protected:
  const Pavement paved = annulus(89);
  const StoneLayout layout = paving::laid_stones(paved, 7);
};

TEST_F(GoodLayout, HoldsInAll) { EXPECT_EQ(failing(paved, as_laid(paved, layout).figures), Ids{}); }

TEST_F(GoodLayout, IsRejectedWithOneStoneRemoved) {
  for (const std::size_t s : {std::size_t{0}, layout.stones.size() / 2, layout.stones.size() - 1}) {
    StoneLayout other = layout;
    const vec2 middle = geometry::centroid(other.stones[s].outline_mm);
    other.stones.erase(other.stones.begin() + static_cast<std::ptrdiff_t>(s));
    const LayoutMeasures measures = as_laid(paved, other);
    EXPECT_EQ(failing(paved, measures.figures), (Ids{"holes", "bare_spot"}));
    EXPECT_GT(measures.figures.bare_spot_mm, 80.0);
    EXPECT_LT(glm::length(measures.bare_spot_mm - middle), 10.0);
    ASSERT_EQ(measures.holes_mm.size(), 1U);
    EXPECT_LT(glm::length(measures.holes_mm[0] - middle), 10.0);
  }
}

// Two stones as one: no overlap, no bare spot, only too large.
TEST(PavementMeasures, RejectAStoneLargerThanItsStock) {
  const Pavement path = small_path();
  StoneLayout layout = paving::laid_stones(path, 1);
  ASSERT_EQ(failing(path, as_laid(path, layout).figures), Ids{});
  std::size_t next = 1;
  while (layout.stones[next].outline_mm[0].y != layout.stones[0].outline_mm[0].y) ++next;
  const auto at = [&](std::size_t s) { return geometry::bounding_box(layout.stones[s].outline_mm); };
  const geometry::Box a = at(0);
  const geometry::Box b = at(next);
  const vec2 low = glm::min(a.low, b.low);
  const vec2 high = glm::max(a.high, b.high);
  layout.stones[0].outline_mm = {low, {high.x, low.y}, high, {low.x, high.y}};
  layout.stones.erase(layout.stones.begin() + static_cast<std::ptrdiff_t>(next));
  const LayoutMeasures measures = as_laid(path, layout);
  EXPECT_NEAR(measures.figures.largest_length_percent, 208.0, 1e-6);
  EXPECT_NEAR(measures.figures.largest_width_percent, 100.0, 1e-6);
  EXPECT_NEAR(measures.figures.largest_area_percent, 208.0, 1e-6);
  EXPECT_EQ(measures.figures.bare_spot_mm, 0.0);
  const Ids ids = failing(path, measures.figures);
  EXPECT_NE(std::ranges::find(ids, "largest_stone"), ids.end());
  // By a twentieth of a millimetre a stone is not larger, by half a millimetre it is.
  const auto longer_by = [&](double mm) {
    StoneLayout other = paving::laid_stones(path, 1);
    for (vec2& p : other.stones[0].outline_mm) {
      if (p.x > 50.0) p.x += mm;
    }
    const Ids failed = failing(path, as_laid(path, other).figures);
    return std::ranges::find(failed, "largest_stone") != failed.end();
  };
  EXPECT_FALSE(longer_by(0.05));
  EXPECT_TRUE(longer_by(0.5));
}

TEST_F(GoodLayout, IsRejectedWithJointsWiderByATwentieth) {
  Pavement wider = paved;
  wider.joint_mm *= 1.05;
  // What stones grown by half the asked joint leave open is then 2 · 0.4 mm of each 97 mm.
  EXPECT_EQ(failing(paved, as_laid(paved, paving::laid_stones(wider, 7)).figures), (Ids{"coverage", "joint_median"}));
}

TEST_F(GoodLayout, IsRejectedWithTheFieldTurnedByThreeDegrees) {
  StoneLayout turned = layout;
  for (paving::Stone& stone : turned.stones) {
    const vec2 middle = geometry::centroid(stone.outline_mm);
    for (vec2& p : stone.outline_mm) p = geometry::on_lattice(middle + rotated(p - middle, Angle::degrees(3.0)));
  }
  const LayoutFigures figures = as_laid(paved, turned).figures;
  EXPECT_NEAR(figures.misaligned_mean_deg, 3.0, 0.5);
  const Ids ids = failing(paved, figures);
  EXPECT_NE(std::ranges::find(ids, "alignment_mean"), ids.end());
  // A constant field, laid anew: nothing else is wrong with it.
  const Pavement straight = paving::pavement(paving::concave_area(), 100, 8, paving::ConstantDirection{Angle::degrees(20)});
  const Pavement other = paving::pavement(paving::concave_area(), 100, 8, paving::ConstantDirection{Angle::degrees(23)});
  EXPECT_EQ(failing(straight, as_laid(straight, paving::laid_stones(straight, 1)).figures), Ids{});
  EXPECT_EQ(failing(straight, as_laid(straight, paving::laid_stones(other, 1)).figures), Ids{"alignment_mean"});
}

TEST(PavementMeasures, TakeStonesLeftOutOnPurposeForNoHoles) {
  Pavement paved = paving::pavement(paving::concave_area(), 100, 8, paving::ConstantDirection{});
  const StoneLayout set_out = paving::laid_stones(paved, 1);
  paved.variation.missing = 0.1;
  StoneLayout lying = paving::laid_stones(paved, 1);
  const LayoutFigures figures = measure::measured(paved, set_out, lying).figures;
  EXPECT_EQ(figures.missing, set_out.stones.size() - lying.stones.size());
  EXPECT_GT(figures.missing, 0U);
  EXPECT_EQ(failing(paved, figures), Ids{});
  // But half of all is not a tenth, and none was asked for without the key.
  lying.stones.resize(lying.stones.size() / 2);
  EXPECT_EQ(failing(paved, measure::measured(paved, set_out, lying).figures), Ids{"missing_stones"});
  lying = set_out;
  lying.stones.pop_back();
  paved.variation.missing = 0.0;
  EXPECT_EQ(failing(paved, measure::measured(paved, set_out, lying).figures), Ids{"missing_stones"});
}

TEST(PavementMeasures, AskOfEachBondWhatItCanGive) {
  const auto of = [](paving::Bond bond, double turn_deg) {
    Pavement paved = paving::pavement(paving::path_area(), 100, 8, paving::ConstantDirection{Angle::degrees(10)});
    paved.stone_mm = {200, 100};
    paved.bonding.bond = bond;
    paved.bonding.turn = Angle::degrees(turn_deg);
    const StoneLayout layout = paving::laid_stones(paved, 1);
    return as_laid(paved, layout).figures;
  };
  using paving::Bond;
  std::vector<Bond> square;
  std::vector<Bond> others;
  for (const paving::BondType* type : paving::bond_types()) {
    if (!type->is_for_scenes || type->bending == paving::Bending::packed) continue;
    (type->has_square_stones ? square : others).push_back(type->id);
  }
  EXPECT_EQ(square, (std::vector{Bond::running, Bond::stack, Bond::herringbone, Bond::basket_weave, Bond::ashlar}));
  EXPECT_GE(others.size(), 4U);
  for (const Bond bond : square) {
    const LayoutFigures figures = of(bond, bond == Bond::herringbone ? 45.0 : 0.0);
    EXPECT_GT(figures.sides, 100U);
    EXPECT_LT(figures.misaligned_p95_deg, 0.01) << static_cast<int>(bond);
    EXPECT_EQ(figures.counted_stones, 0U) << "regular is not told of bonds";
  }
  for (const Bond bond : others) {
    const LayoutFigures figures = of(bond, 0.0);
    EXPECT_EQ(figures.sides, 0U);
    EXPECT_EQ(figures.shaped, 0U);
    EXPECT_GT(figures.joints, 50U);
    EXPECT_GT(figures.covered_percent, 99.0);
  }
}

TEST(PavementMeasures, AreTheSameWithAnyNumberOfThreads) {
  const Pavement paved = paving::pavement(paving::concave_area(), 100, 8, paving::BoundaryDirection{});
  const StoneLayout layout = paving::laid_stones(paved, 7);
  std::vector<LayoutMeasures> all;
  for (const int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    all.push_back(as_laid(paved, layout));
  }
  for (const LayoutMeasures& other : all) {
    EXPECT_EQ(other.figures.covered_percent, all[0].figures.covered_percent);
    EXPECT_EQ(other.figures.misaligned_mean_deg, all[0].figures.misaligned_mean_deg);
    EXPECT_EQ(other.figures.irregular_spots, all[0].figures.irregular_spots);
    EXPECT_EQ(other.figures.field.least_spots(), all[0].figures.field.least_spots());
    EXPECT_EQ(other.joints_percent, all[0].joints_percent);
  }
}

TEST(PavementFindings, AreOfTheWorstSeed) {
  const Pavement paved = small_path();
  std::vector<LayoutFigures> layouts(3, as_laid(paved, paving::laid_stones(paved, 1)).figures);
  layouts[1].holes = 2;
  layouts[2].joint_median_percent = 96.0;
  const std::vector<Finding> findings = pavement_findings(paved, layouts);
  EXPECT_EQ(finding_of(findings, "holes").figure, 2.0);
  EXPECT_EQ(finding_of(findings, "holes").verdict, Verdict::fails);
  EXPECT_EQ(finding_of(findings, "joint_median").figure, 96.0);
  EXPECT_EQ(finding_of(findings, "joint_median").verdict, Verdict::fails);
  EXPECT_EQ(finding_of(findings, "coverage").verdict, Verdict::holds);
}

TEST(PavementFindings, HoldCobblesAndScalesToSoundnessAlone) {
  Pavement paved = small_path();
  LayoutFigures figures = as_laid(paved, paving::laid_stones(paved, 1)).figures;
  figures.misaligned_mean_deg = 30.0;
  figures.joint_median_percent = 200.0;
  figures.area_spread_percent = 60.0;
  figures.faults.overlaps = 1;
  figures.holes = 1;
  EXPECT_EQ(failing(paved, figures), (Ids{"alignment_mean", "overlaps", "holes", "joint_median", "area_spread"}));
  for (const paving::CellForm form : {paving::CellForm::cobble, paving::CellForm::scale}) {
    paved.cell.form = form;
    EXPECT_EQ(failing(paved, figures), (Ids{"overlaps", "holes"}));
  }
}

}  // namespace
}  // namespace shatterpave::measure
