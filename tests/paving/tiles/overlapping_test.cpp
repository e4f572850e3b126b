#include "paving/tiles/overlapping.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "geometry/clip.h"
#include "geometry/hull.h"
#include "geometry/lattice.h"

namespace shatterpave::paving {
namespace {

using geometry::Polygon;

constexpr double seam_mm = 0.008;

Polygon box(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

TEST(Overlapping, SeamsOfRoundingAreNone) {
  const Polygon tile = box(0, 0, 100, 100);
  EXPECT_FALSE(lie_over_one_another(tile, box(100, 0, 200, 100), seam_mm));
  EXPECT_FALSE(lie_over_one_another(tile, box(99.995, -30, 200, 60), seam_mm));
  EXPECT_TRUE(lie_over_one_another(tile, box(99.98, -30, 200, 60), seam_mm));
  EXPECT_FALSE(lie_over_one_another(tile, box(150, 0, 200, 100), seam_mm));
  EXPECT_FALSE(lie_over_one_another(tile, {{100, 50}, {180, 20}, {180, 80}}, seam_mm));
  EXPECT_TRUE(lie_over_one_another(tile, {{99.9, 50}, {180, 20}, {180, 80}}, seam_mm));
}

TEST(Overlapping, NeedsNoCornerWithin) {
  const Polygon tile = box(0, 0, 100, 100);
  EXPECT_TRUE(lie_over_one_another(tile, box(-50, 40, 150, 60), seam_mm));
  EXPECT_TRUE(lie_over_one_another(tile, box(40, 40, 60, 60), seam_mm));
  EXPECT_TRUE(lie_over_one_another(box(40, 40, 60, 60), tile, seam_mm));
  EXPECT_TRUE(lie_over_one_another(tile, tile, seam_mm));
}

// Against clipping: pairs of random convex tiles, most of which meet.
TEST(Overlapping, AgreesWithTheAreaInCommon) {
  std::vector<Polygon> tiles;
  for (std::uint64_t t = 0; t < 120; ++t) {
    std::uint32_t number = 0;
    const auto draw = [&] { return uniform(3, {Stream::hand_line, Id("tile").child(t), number++}); };
    const vec2 middle = 400.0 * vec2{draw(), draw()};
    std::vector<vec2> points;
    for (int i = 0; i < 6; ++i) points.push_back(geometry::on_lattice(middle + 60.0 * vec2{draw() - 0.5, draw() - 0.5}));
    tiles.push_back(geometry::convex_hull(points));
  }
  const auto found = overlapping_pairs(tiles, seam_mm);
  std::size_t next = 0;
  for (std::size_t a = 0; a < tiles.size(); ++a) {
    for (std::size_t b = a + 1; b < tiles.size(); ++b) {
      double area = 0.0;
      for (const geometry::Region& common : geometry::intersection(tiles[a], {tiles[b], {}})) area += geometry::area(common);
      const bool told = next < found.size() && found[next] == std::pair(a, b);
      if (told) ++next;
      if (area > 0.05) {
        EXPECT_TRUE(told) << a << " " << b << " " << area;
      }
      if (area < 1e-5) {
        EXPECT_FALSE(told) << a << " " << b << " " << area;
      }
    }
  }
  EXPECT_EQ(next, found.size());
  EXPECT_GT(next, 50U);
  EXPECT_LT(next, 3000U);
}

}  // namespace
}  // namespace shatterpave::paving
