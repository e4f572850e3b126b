#include "paving/field/size_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/segment_distance.h"
#include "measure/pavement_measures.h"
#include "paving/laying.h"
#include "paving/layout_quality.h"
#include "paving/limits.h"
#include "paving/paved_areas.h"
#include "paving/seamless.h"

namespace shatterpave::paving {
namespace {

geometry::Region sized_area(double width, double height) { return {{{0, 0}, {width, 0}, {width, height}, {0, height}}, {}}; }

Pavement with_sizes(geometry::Region area, Direction direction, Sizes sizes) {
  Pavement result = pavement(std::move(area), 60, 5, std::move(direction));
  result.sizes = std::move(sizes);
  return result;
}

SizeField size_field_of(const Pavement& pavement) { return {pavement, geometry::RegionIndex(pavement.area)}; }

TEST(SizeField, FollowsTheDistanceFromTheEdgeAndItsHoles) {
  geometry::Region area = sized_area(8000, 8000);
  area.holes.push_back({{3900, 3900}, {3900, 4100}, {4100, 4100}, {4100, 3900}});
  const SizeField field = size_field_of(with_sizes(area, straight(0), SizesFromEdge{{0.5, 1.5, 1500.0}}));
  EXPECT_NEAR(field.at({0, 4000}), 0.5, 0.01);
  EXPECT_NEAR(field.at({750, 4000}), 1.0, 0.01);
  EXPECT_NEAR(field.at({2000, 4000}), 1.5, 0.01);
  EXPECT_NEAR(field.at({3900 - 300, 4000}), 0.7, 0.01);
  EXPECT_NEAR(field.at({-100, 4000}), 0.5, 0.01);  // beyond the border as at it
  EXPECT_NEAR(field.smallest(), 0.5, 1e-6);
  EXPECT_NEAR(field.largest(), 1.5, 1e-6);
}

TEST(SizeField, FollowsTheDistanceFromLines) {
  const std::vector<vec2> line = {{0, 0}, {2000, 2000}, {4000, 2000}};
  const SizeField field =
      size_field_of(with_sizes(sized_area(4000, 4000), straight(0), SizesFromLines{{1.5, 0.5, 1200.0}, {line}}));
  for (const vec2 place : {vec2{500, 500}, vec2{1000, 2000}, vec2{3000, 1500}, vec2{3000, 3900}, vec2{2000, 2100}}) {
    double away = 1e9;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      away = std::min(away, geometry::distance_to_segment(place, line[i], line[i + 1]));
    }
    EXPECT_NEAR(field.at(place), 1.5 - std::min(1.0, away / 1200.0), 0.02) << place.x << ' ' << place.y;
  }
}

TEST(SizeField, FollowsAPictureFromItsTopRow) {
  SizesOfMap map{0.5, 1.5, {0, 0}, {8000, 8000}, 2, {0.0F, 0.25F, 0.5F, 1.0F}};
  const SizeField field = size_field_of(with_sizes(sized_area(8000, 8000), straight(0), map));
  EXPECT_NEAR(field.at({1000, 7000}), 0.5, 0.01);
  EXPECT_NEAR(field.at({7000, 7000}), 0.75, 0.01);
  EXPECT_NEAR(field.at({1000, 1000}), 1.0, 0.01);
  EXPECT_NEAR(field.at({7000, 1000}), 1.5, 0.01);
  EXPECT_NEAR(field.at({4000, 4000}), 0.9375, 0.01);
}

TEST(SizeField, GrowsNoFasterThanRowsCanBear) {
  // A jump from a quarter to four: a step away the size may be larger by `most_growth`, on the diagonals of the grid 8 % more.
  SizesOfMap map{0.25, 4.0, {0, 0}, {12000, 6000}, 48, std::vector<float>(48, 0.0F)};
  std::fill(map.greys.begin() + 24, map.greys.end(), 1.0F);
  const SizeField field = size_field_of(with_sizes(sized_area(12000, 6000), straight(0), map));
  EXPECT_NEAR(field.at({100, 3000}), 0.25, 0.01);
  double steepest = 0.0;
  for (double x = 0.0; x < 12000.0; x += 65.0) {
    for (const vec2 step : {vec2{65, 0}, vec2{0, 65}, vec2{46, 46}}) {
      steepest = std::max(steepest, std::abs(field.at(vec2{x, 3000} + step) - field.at({x, 3000})));
    }
  }
  EXPECT_LT(steepest, 1.09 * most_growth);
  EXPECT_GT(steepest, 0.9 * most_growth);
}

// How stones of a layout follow the sizes that `asked` gives: of inner whole ones the root of their area over what that gives.
struct Following {
  double mean = 0.0;
  double within_15_percent = 0.0;  // share
};

Following following(const Pavement& pavement, const StoneLayout& layout, const std::function<double(vec2)>& asked) {
  Following result;
  double count = 0.0;
  for (const Stone& stone : layout.stones) {
    if (stone.kind != StoneKind::whole) continue;
    const vec2 middle = geometry::centroid(stone.outline_mm);
    const double ratio = std::sqrt(geometry::area(stone.outline_mm)) / (asked(middle) * pavement.stone_mm.x);
    result.mean += ratio;
    result.within_15_percent += std::abs(ratio - 1.0) < 0.15 ? 1.0 : 0.0;
    count += 1.0;
  }
  result.mean /= count;
  result.within_15_percent /= count;
  return result;
}

bool follows(const Following& f) { return std::abs(f.mean - 1.0) < 0.03 && f.within_15_percent > 0.9; }

TEST(SizeField, PackedStonesHaveTheSizesThatAreAskedFor) {
  const auto edge_size = [](double far) {
    return [far](vec2 p) {
      const double away = std::min({p.x, p.y, 5000.0 - p.x, 4000.0 - p.y});
      return 0.6 + std::min(1.0, away / 1500.0) * (far - 0.6);
    };
  };
  for (const Direction& direction : {straight(0), Direction(BoundaryDirection{})}) {
    const Pavement paved = with_sizes(sized_area(5000, 4000), direction, SizesFromEdge{{0.6, 1.8, 1500.0}});
    const StoneLayout layout = laid_stones(paved, 1);
    EXPECT_EQ(faults(paved, layout).total(), 0U);
    const Following right = following(paved, layout, edge_size(1.8));
    EXPECT_TRUE(follows(right)) << right.mean << ' ' << right.within_15_percent;
    // Wrong twins: sizes a twelfth larger in the middle, sizes the other way round, one size.
    EXPECT_FALSE(follows(following(paved, layout, edge_size(1.95))));
    EXPECT_FALSE(follows(following(paved, layout, [&](vec2 p) { return 2.4 - edge_size(1.8)(p); })));
    EXPECT_FALSE(follows(following(paved, layout, [](vec2) { return 1.2; })));
    const LayoutQuality q = quality(paved, layout);
    EXPECT_GT(q.coverage, 0.99);
    EXPECT_LT(q.mean_misalignment_deg, 4.0);
    EXPECT_GT(q.four_sided, 0.85);
  }
}

// Areas, fields, joints and sizes at random: stones, cobbles and scales never overlap, nor leave the area.
TEST(SizeField, StonesOfRandomPlansAreSound) {
  std::mt19937_64 draw(11);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(draw() >> 11) * 0x1.0p-53;
  };
  const auto size = [&] { return between(size_bounds.low, 2.5); };
  for (int number = 0; number < 60; ++number) {
    geometry::Region area{circle({0, 0}, between(400, 1100), 3 + number % 12), {}};
    if (number % 3 == 0) area.holes.push_back(circle({between(-90, 90), between(-90, 90)}, between(20, 80), 5));
    const Direction direction = number % 2 == 0 ? straight(between(-90, 90)) : Direction(BoundaryDirection{});
    Pavement paved = pavement(area, between(50, 110), number % 5 == 0 ? 0.0 : between(1, 12), direction);
    const SizeRamp ramp{size(), size(), between(100, 1500)};
    if (number % 4 == 0) {
      paved.sizes = SizesFromLines{ramp, {{{-500, between(-300, 300)}, {500, between(-300, 300)}}}};
    } else if (number % 4 == 1) {
      SizesOfMap map{size(), size(), {-800, -800}, {800, 800}, 3, {}};
      for (int i = 0; i < 9; ++i) map.greys.push_back(static_cast<float>(between(0, 1)));
      paved.sizes = map;
    } else {
      paved.sizes = SizesFromEdge{ramp};
    }
    paved.cell.form = static_cast<CellForm>(number % 3);
    const StoneLayout layout = laid_stones(paved, static_cast<std::uint64_t>(number));
    const LayoutFaults found = faults(paved, layout);
    EXPECT_EQ(found.total(), 0U) << "number " << number << ": " << found.invalid << " invalid, " << found.overlaps
                                 << " overlaps, " << found.outside << " outside, of " << layout.stones.size();
    EXPECT_FALSE(layout.stones.empty()) << number;
  }
}

TEST(SizeField, StonesOfOneSizeAreAsGoodByAFieldAsWithout) {
  Pavement plain = pavement(quarter_annulus(), 150, 8, RadialDirection{{0, 0}, 0.0});
  Pavement sized = plain;
  sized.sizes = SizesOfMap{1.0, 1.0, {0, 0}, {10000, 10000}, 1, {0.5F}};
  const LayoutQuality a = quality(plain, laid_stones(plain, 1));
  const LayoutQuality b = quality(sized, laid_stones(sized, 1));
  EXPECT_NEAR(a.mean_misalignment_deg, b.mean_misalignment_deg, 0.1);
  EXPECT_NEAR(a.four_sided, b.four_sided, 0.005);
  EXPECT_NEAR(a.area_spread, b.area_spread, 0.005);
  EXPECT_NEAR(a.coverage, b.coverage, 0.001);
}

TEST(SizeField, ThreadsDoNotShow) {
  const Pavement paved = with_sizes(concave_area(), BoundaryDirection{}, SizesFromEdge{{0.6, 2.0, 1500.0}});
  const StoneLayout all = laid_stones(paved, 3);
  const ThreadLimit limit(1);
  EXPECT_EQ(laid_stones(paved, 3), all);
}

TEST(SizeField, OtherBondsAndTilesRefuseSizes) {
  Pavement paved = with_sizes(sized_area(2000, 2000), straight(0), SizesFromEdge{{0.5, 1.0, 1000.0}});
  EXPECT_THROW(static_cast<void>(seamless_tile(paved, 1)), InputError);
  paved.bonding.bond = Bond::running;
  EXPECT_THROW(static_cast<void>(laid_stones(paved, 1)), InputError);
  paved.bonding.bond = Bond::packed;
  paved.sizes = SizesFromEdge{{0.1, 1.0, 1000.0}};
  EXPECT_THROW(static_cast<void>(laid_stones(paved, 1)), InputError);
}

}  // namespace
}  // namespace shatterpave::paving
