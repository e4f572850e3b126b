#include "paving/surface/stone_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/functions.h"
#include "paving/patch_seams.h"

namespace shatterpave::paving {
namespace {

using geometry::BezierPatch;
using geometry::Polygon;

const Polygon square_stone = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
const Polygon cell_of_an_l = {{0, 0}, {100, 0}, {100, 100}, {60, 100}, {60, 50}, {0, 50}};

StoneDraws plain_draws() {
  StoneDraws draws;
  draws.height_mm = 18.0;
  draws.inset = 0.1;
  return draws;
}

TEST(StoneSurface, FourCornersAreOnePatchOfThePaper) {
  const std::vector<BezierPatch> patches = surface_patches(square_stone, plain_draws());
  ASSERT_EQ(patches.size(), 1U);
  const BezierPatch& patch = patches[0];
  EXPECT_EQ(patch.at(0, 0), vec3(0, 0, 0));
  EXPECT_EQ(patch.at(3, 0), vec3(100, 0, 0));
  EXPECT_EQ(patch.at(3, 3), vec3(100, 100, 0));
  EXPECT_EQ(patch.at(0, 3), vec3(0, 100, 0));
  EXPECT_EQ(patch.at(1, 1), vec3(10, 10, 18));
  EXPECT_EQ(patch.at(2, 1), vec3(90, 10, 18));
  EXPECT_EQ(patch.at(2, 2), vec3(90, 90, 18));
  EXPECT_EQ(patch.at(0, 1), vec3(0, 10, 0));
  EXPECT_DOUBLE_EQ(point(patch, 0.5, 0.5).z, 18.0 * 9.0 / 16.0);
}

TEST(StoneSurface, TiltRaisesOneSideOnly) {
  StoneDraws draws = plain_draws();
  draws.slope = {0.01, 0.0};
  const BezierPatch patch = surface_patches(square_stone, draws).front();
  EXPECT_NEAR(patch.at(2, 1).z, 18.4, 1e-12);
  EXPECT_NEAR(patch.at(1, 1).z, 17.6, 1e-12);
  EXPECT_EQ(patch.at(0, 1).z, 0.0);
}

TEST(StoneSurface, VerticesOnASideAreNoCorners) {
  const Polygon with_middle = {{0, 0}, {50, 0.2}, {100, 0}, {100, 100}, {40, 100}, {0, 100}};
  EXPECT_EQ(corners(with_middle, 1.0), square_stone);
  EXPECT_EQ(surface_patches(with_middle, plain_draws()), surface_patches(square_stone, plain_draws()));
}

TEST(StoneSurface, SplitStonesMeetSmoothly) {
  int split = 0;
  for (const int count : {3, 5, 6, 7}) {
    for (std::uint64_t number = 0; number < 60; ++number) {
      const Polygon outline = number == 0 ? regular(count, 55.0) : uneven(count, number);
      const std::vector<BezierPatch> patches = surface_patches(outline, plain_draws());
      if (patches.size() == 1) continue;  // with a corner or more that are within the tolerance
      ++split;
      const std::size_t corner_count = patches.size() / 4;
      ASSERT_EQ(patches.size(), 4 * corner_count);
      // For each side three along the ring, two between ring and crown, and one within the crown.
      EXPECT_EQ(seams(patches).size(), 6 * corner_count);
      expect_smooth(patches);
    }
  }
  EXPECT_GT(split, 180);
}

TEST(StoneSurface, SmoothnessTestSeesACrease) {
  std::vector<BezierPatch> patches = surface_patches(regular(5, 55.0), plain_draws());
  patches[0].at(2, 2).z += 0.01;
  double worst = 0.0;
  for (const Seam& seam : seams(patches)) {
    worst = std::max(worst, glm::length(normal_on_border(patches[seam.first], seam.first_border, 0.5) -
                                        normal_on_border(patches[seam.second], seam.second_border, 0.5)));
  }
  EXPECT_GT(worst, 1e-6);
}

// The area of patches seen from above, by a fine grid of each.
double area_from_above(const std::vector<BezierPatch>& patches) {
  constexpr int steps = 24;
  double twice = 0.0;
  for (const BezierPatch& patch : patches) {
    for (int i = 0; i < steps; ++i) {
      for (int j = 0; j < steps; ++j) {
        const auto at = [&](int a, int b) {
          const vec3 p = point(patch, static_cast<double>(a) / steps, static_cast<double>(b) / steps);
          return vec2{p.x, p.y};
        };
        twice += cross(at(i + 1, j + 1) - at(i, j), at(i, j + 1) - at(i + 1, j));
      }
    }
  }
  return 0.5 * twice;
}

TEST(StoneSurface, CoversTheStoneOnce) {
  std::vector<Polygon> outlines = {square_stone, cell_of_an_l};
  for (std::uint64_t number = 0; number < 30; ++number) {
    for (const int count : {3, 4, 5, 6, 8}) outlines.push_back(uneven(count, number));
  }
  for (const Polygon& outline : outlines) {
    const std::vector<BezierPatch> patches = surface_patches(outline, plain_draws());
    // Vertices left out may take corner_tolerance of the size times half its breadth, each.
    EXPECT_NEAR(area_from_above(patches) / geometry::area(outline), 1.0, 0.03);
    for (const BezierPatch& patch : patches) {
      for (const double u : {0.02, 0.3, 0.5, 0.98}) {
        for (const double v : {0.02, 0.4, 0.98}) {
          EXPECT_GT(unit_normal(patch, u, v).z, 0.0);
          const vec3 p = point(patch, u, v);
          EXPECT_TRUE(geometry::contains(outline, {p.x, p.y})) << p.x << ' ' << p.y;
        }
      }
    }
  }
}

TEST(StoneSurface, BorderIsHiddenByTheBed) {
  StoneSurface surface;
  for (const int count : {3, 4, 5, 6}) {
    for (const BezierPatch& patch : surface_patches(regular(count, 55.0), plain_draws())) {
      for (int border = 0; border < 4; ++border) {
        for (double t = 0.0; t <= 1.0; t += 0.25) {
          const vec3 p = on_border(patch, border, t);
          // On the outline: as far from the centre as a side.
          if (glm::length(vec2{p.x, p.y}) < 55.0 * cosine(pi / count) - 1e-9) continue;
          if (!geometry::contains(regular(count, 54.999), {p.x, p.y})) {
            EXPECT_LT(p.z, bed_level_mm(surface));
          }
        }
      }
    }
  }
  // The visible joint: where the single patch rises through the bed, at most a millimetre from the outline.
  const BezierPatch patch = surface_patches(square_stone, plain_draws()).front();
  double u = 0.0;
  while (point(patch, u, 0.5).z < bed_level_mm(surface)) u += 1e-4;
  EXPECT_LT(point(patch, u, 0.5).x, 1.0);
}

TEST(StoneSurface, ReflexCornerIsBrokenIntoConvexPieces) {
  const std::vector<BezierPatch> patches = surface_patches(cell_of_an_l, plain_draws());
  EXPECT_EQ(patches.size(), 2U);  // two rectangles
}

TEST(StoneDraws, DependOnTheStoneAlone) {
  Pavement pavement;
  pavement.name = "path";
  const StoneDraws seventh = stone_draws(pavement, 7, 7);
  for (int id = 20; id-- > 0;) static_cast<void>(stone_draws(pavement, 7, id));
  const StoneDraws again = stone_draws(pavement, 7, 7);
  EXPECT_EQ(seventh.height_mm, again.height_mm);
  EXPECT_EQ(seventh.relief_place, again.relief_place);
  // More stones, another area, another relief: still the same.
  pavement.stone_mm = {200.0, 50.0};
  pavement.relief.rms_mm = 3.0;
  EXPECT_EQ(seventh.colour, stone_draws(pavement, 7, 7).colour);
  pavement.name = "yard";
  EXPECT_NE(seventh.colour, stone_draws(pavement, 7, 7).colour);
}

TEST(StoneDraws, KeepToTheirSpread) {
  Pavement pavement;
  pavement.name = "path";
  double lowest = std::numeric_limits<double>::infinity();
  double highest = 0.0;
  double sum = 0.0;
  for (int id = 0; id < 2000; ++id) {
    const StoneDraws draws = stone_draws(pavement, 7, id);
    lowest = std::min(lowest, draws.height_mm);
    highest = std::max(highest, draws.height_mm);
    sum += draws.height_mm;
    EXPECT_GE(draws.inset, 0.0);
    EXPECT_LE(draws.inset, 0.5);
  }
  const double spread = pavement.surface.height_mm * pavement.surface.height_spread;
  EXPECT_NEAR(lowest, pavement.surface.height_mm - spread, 0.02 * spread);
  EXPECT_NEAR(highest, pavement.surface.height_mm + spread, 0.02 * spread);
  // The mean of 2000 uniform draws errs by spread / sqrt(3 · 2000) = 0.013 of it.
  EXPECT_NEAR(sum / 2000.0, pavement.surface.height_mm, 0.05 * spread);
}

}  // namespace
}  // namespace shatterpave::paving
