#include "measure/stone_stock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "paving/bonds/table.h"
#include "paving/laying.h"
#include "paving/paved_areas.h"

namespace shatterpave::measure {
namespace {

using geometry::Polygon;
using paving::Bond;
using paving::Pavement;

Polygon rectangle(double length, double width) { return {{0, 0}, {length, 0}, {length, width}, {0, width}}; }

Polygon turned(Polygon polygon, double degrees) {
  for (vec2& p : polygon) p = rotated(p, Angle::degrees(degrees));
  return polygon;
}

StockLimit stock(double length, double width) { return {{{length, width}}, length * width, 1.0}; }

TEST(StoneStock, IsHeldAgainstTheStoneAtItsBestRotation) {
  for (const double degrees : {0.0, 37.0, 90.0, 151.0}) {
    const StockShare whole = stock_share(turned(rectangle(200, 100), degrees), stock(200, 100));
    EXPECT_NEAR(whole.length, 1.0, 1e-9) << degrees;
    EXPECT_NEAR(whole.width, 1.0, 1e-9) << degrees;
    EXPECT_NEAR(whole.area, 1.0, 1e-9) << degrees;
    const StockShare joined = stock_share(turned(rectangle(250, 100), degrees), stock(200, 100));
    EXPECT_NEAR(std::max(joined.length, joined.width), 1.25, 1e-9) << "no rotation helps";
    EXPECT_NEAR(joined.area, 1.25, 1e-9);
  }
  // A long strip fits askew: along a square's diagonal.
  const StockShare strip = stock_share(rectangle(130, 5), stock(100, 100));
  EXPECT_NEAR(strip.length, strip.width, 1e-9);
  EXPECT_NEAR(strip.length, (130.0 + 5.0) / std::sqrt(2.0) / 100.0, 1e-9);
  // A square stood on its corner is no larger.
  EXPECT_NEAR(stock_share(turned(rectangle(100, 100), 45), stock(100, 100)).length, 1.0, 1e-9);
}

double excess_by_search(const Polygon& polygon, vec2 face) {
  double best = 1e300;
  for (double degrees = 0.0; degrees < 180.0; degrees += 0.01) {
    const vec2 along = Angle::degrees(degrees).direction();
    vec2 low{1e300, 1e300};
    vec2 high = -low;
    for (const vec2& p : polygon) {
      const vec2 q{glm::dot(p, along), glm::dot(p, left_of(along))};
      low = glm::min(low, q);
      high = glm::max(high, q);
    }
    best = std::min(best, std::max((high.x - low.x) / face.x, (high.y - low.y) / face.y));
  }
  return best;
}

TEST(StoneStock, IsAsNearToFittingAsASearchFinds) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto draw = [&](std::uint32_t n) { return uniform(seed, {Stream::packing, Id("stone"), n}); };
    Polygon polygon;
    const std::uint32_t corners = 3 + static_cast<std::uint32_t>(6.0 * draw(0));
    for (std::uint32_t i = 0; i < corners; ++i) polygon.push_back({200.0 * draw(2 * i + 1), 80.0 * draw(2 * i + 2)});
    const vec2 face{60.0 + 100.0 * draw(50), 60.0 + 100.0 * draw(51)};
    const StockShare share = stock_share(polygon, stock(face.x, face.y));
    const double found = excess_by_search(polygon, face);
    EXPECT_LE(std::max(share.length, share.width), found + 1e-9) << seed;
    EXPECT_GE(std::max(share.length, share.width), found * (1.0 - 1e-3)) << seed;
  }
}

// What the stock is of each bond: whole stones are as large as it, and none is larger.
TEST(StoneStock, OfABondIsItsLargestWholeStone) {
  std::size_t seen = 0;
  for (const paving::BondType* type : paving::bond_types()) {
    const Bond bond = type->id;
    Pavement any = paving::pavement({rectangle(6000, 5000), {}}, 100, 8, paving::straight(10));
    any.bonding.bond = bond;
    // The others make stones as they come: below.
    if (!stock_limit(any).most) continue;
    ++seen;
    for (const vec2 stone_mm : {vec2{100, 100}, vec2{210, 95}, vec2{240, 60}}) {
      Pavement paved = paving::pavement({rectangle(6000, 5000), {}}, 100, 8, paving::straight(10));
      paved.bonding.bond = bond;
      paved.stone_mm = stone_mm;
      const StockLimit limit = stock_limit(paved);
      ASSERT_EQ(limit.most, 1.0);
      StockShare largest;
      for (const paving::Stone& stone : paving::laid_stones(paved, 1).stones) {
        if (stone.kind != paving::StoneKind::whole) continue;
        const StockShare share = stock_share(stone.outline_mm, limit);
        largest = {std::max(largest.length, share.length), std::max(largest.width, share.width),
                   std::max(largest.area, share.area)};
      }
      for (const double most : {largest.length, largest.width, largest.area}) {
        EXPECT_NEAR(most, 1.0, 0.0005) << static_cast<int>(bond) << ", " << stone_mm.x << " × " << stone_mm.y;
      }
    }
  }
  EXPECT_EQ(seen, 9U);
}

TEST(StoneStock, IsWithoutLimitWhereABondMakesStonesAsTheyCome) {
  Pavement paved = paving::pavement(paving::path_area(), 100, 8, paving::straight(0));
  for (const Bond bond : {Bond::segmental_arc, Bond::fan, Bond::crazy, Bond::course}) {
    paved.bonding.bond = bond;
    EXPECT_EQ(stock_limit(paved).most, std::nullopt);
    EXPECT_EQ(border_stock_limit(paved).most, 1.0);
  }
}

}  // namespace
}  // namespace shatterpave::measure
