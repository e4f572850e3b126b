#include "paving/tiles/filling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "geometry/clip.h"
#include "geometry/lattice.h"
#include "paving/paved_areas.h"
#include "paving/tiles/stock.h"

namespace shatterpave::paving {
namespace {

using geometry::Polygon;
using geometry::Region;

double draw(std::uint64_t seed, std::uint32_t index) { return uniform(seed, {Stream::stone_place, Id("filling"), index}); }

// Quadrilaterals anywhere about an area of 2 m, turned any way.
std::vector<Tile> random_tiles(std::uint64_t seed, int count) {
  std::vector<Tile> tiles;
  std::uint32_t index = 0;
  for (int t = 0; t < count; ++t) {
    const vec2 at = 2400.0 * vec2{draw(seed, index), draw(seed, index + 1)} - vec2{200.0, 200.0};
    const vec2 axis = Angle::degrees(360.0 * draw(seed, index + 2)).direction();
    const vec2 along = (50.0 + 300.0 * draw(seed, index + 3)) * axis;
    const vec2 across = (20.0 + 200.0 * draw(seed, index + 4)) * left_of(axis);
    index += 5;
    Polygon outline{at, at + along, at + along + across, at + across};
    for (vec2& p : outline) p = geometry::on_lattice(p);
    tiles.push_back({std::move(outline), axis});
  }
  return tiles;
}

double common_mm2(const Polygon& a, const Polygon& b) {
  double total = 0.0;
  for (const Region& part : geometry::intersection(a, {b, {}})) total += geometry::area(part);
  return total;
}

TEST(Filling, NeitherOverlapsNorLeavesAnything) {
  const Region area = concave_area();
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto tiles = random_tiles(seed, 60);
    const auto filled = filling_tiles(tiles, area);
    double total = 0.0;
    double border = 0.0;
    for (std::size_t i = 0; i < filled.size(); ++i) {
      ASSERT_TRUE(geometry::is_simple(filled[i].outline_mm)) << seed;
      total += geometry::area(filled[i].outline_mm);
      border += 4.0 * geometry::area(filled[i].outline_mm) / stoutness_mm(filled[i].outline_mm);
      for (std::size_t j = 0; j < i; ++j) {
        // Rounding: 2 µm along the border that two share, of at most 2 m.
        ASSERT_LT(common_mm2(filled[i].outline_mm, filled[j].outline_mm), 0.004 * 2000.0) << seed;
      }
    }
    // A side strays by 2 µm at the most.
    EXPECT_NEAR(total, geometry::area(area), 0.002 * border) << seed;
  }
}

TEST(Filling, AnEarlierTileKeepsWhatTwoHaveInCommon) {
  const Region area{{{0, 0}, {300, 0}, {300, 100}, {0, 100}}, {}};
  const Tile first{{{0, 0}, {200, 0}, {200, 100}, {0, 100}}, {1, 0}};
  const Tile second{{{100, 0}, {250, 0}, {250, 100}, {100, 100}}, {0, 1}};
  const auto filled = filling_tiles({first, second}, area);
  ASSERT_EQ(filled.size(), 3U);
  EXPECT_EQ(geometry::area(filled[0].outline_mm), 20000.0);
  EXPECT_FALSE(filled[0].cut);
  EXPECT_EQ(geometry::area(filled[1].outline_mm), 5000.0);
  EXPECT_TRUE(filled[1].cut);
  // What is left lies along its neighbour.
  EXPECT_EQ(geometry::area(filled[2].outline_mm), 5000.0);
  EXPECT_EQ(filled[2].axis, vec2(0, 1));
  EXPECT_TRUE(filled[2].cut);
}

// A gap all round tiles in the middle was once taken for its outline alone, and laid over what lies in it.
TEST(Filling, AGapRoundTilesHasThemAsHoles) {
  const Region area{{{0, 0}, {300, 0}, {300, 300}, {0, 300}}, {}};
  const Tile island{{{100, 100}, {200, 100}, {200, 200}, {100, 200}}, {1, 0}};
  const auto filled = filling_tiles({island}, area);
  double total = 0.0;
  for (const Tile& tile : filled) total += geometry::area(tile.outline_mm);
  EXPECT_EQ(total, 90000.0);
  for (std::size_t i = 1; i < filled.size(); ++i) EXPECT_EQ(common_mm2(filled[0].outline_mm, filled[i].outline_mm), 0.0);
}

// Holes down to the lattice's step, of any shape, in regions wide and tall: what is left has none, and nothing else is gone.
TEST(Filling, CutsThroughHolesOfAnySize) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const double um = geometry::to_mm(1);
    const vec2 size = seed % 2 == 0 ? vec2{200.0, 60.0} : vec2{60.0, 200.0};
    Region region{{{0.0, 0.0}, {size.x, 0.0}, size, {0.0, size.y}}, {}};
    double holes_mm2 = 0.0;
    for (std::uint32_t h = 0; h < 6; ++h) {
      const vec2 low = geometry::on_lattice(vec2{0.1 + 0.15 * h, 0.1 + 0.6 * draw(seed, 20 * h)} * size);
      // 1 µm to 8 mm, each way by itself.
      const auto length = [&](std::uint32_t index) {
        return geometry::to_mm(1 + std::llround(8000.0 * std::pow(draw(seed, index), 8)));
      };
      const vec2 extent{length(20 * h + 1), length(20 * h + 2)};
      Polygon hole{low, low + vec2{0.0, extent.y}, low + extent};  // clockwise
      if (draw(seed, 20 * h + 3) < 0.5) hole.push_back(low + vec2{extent.x, 0.0});
      if (draw(seed, 20 * h + 4) < 0.3) hole[0].x -= um;
      for (vec2& p : hole) p = geometry::on_lattice(p);
      holes_mm2 += geometry::area(hole);
      region.holes.push_back(std::move(hole));
    }
    const auto parts = without_holes(region);
    double total = 0.0;
    for (const Polygon& part : parts) {
      ASSERT_TRUE(geometry::is_simple(part)) << seed;
      for (const Polygon& hole : region.holes) {
        ASSERT_LT(common_mm2(part, {hole.rbegin(), hole.rend()}), 0.001 * 8.0) << seed;
      }
      total += geometry::area(part);
    }
    // A side of a hole strays by 1 µm where it is cut, and 1 µm is left out about a slit.
    ASSERT_NEAR(total, size.x * size.y - std::abs(holes_mm2), 0.002 * 6 * 2 * 8.0) << seed;
    ASSERT_GE(parts.size(), 1U);
  }
}

}  // namespace
}  // namespace shatterpave::paving
