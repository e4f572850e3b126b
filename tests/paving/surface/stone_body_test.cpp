#include "paving/surface/stone_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/region_index.h"
#include "paving/catalogue/finishes.h"
#include "paving/derived/kerb.h"
#include "paving/laying.h"
#include "paving/layout_quality.h"
#include "paving/patch_seams.h"
#include "paving/surface/ground.h"
#include "paving/surface/stone_surface.h"
#include "paving/surface/wear.h"

namespace shatterpave::paving {
namespace {

using geometry::BezierPatch;
using geometry::Polygon;

const Polygon square = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};

Pavement finished(Finish finish) {
  Pavement pavement;
  pavement.name = "path";
  for (const FinishPreset& preset : finish_presets) {
    if (preset.body.finish != finish) continue;
    pavement.body = preset.body;
    pavement.surface.height_mm = preset.height_mm;
    pavement.surface.height_spread = preset.height_spread;
    pavement.variation.tilt = Angle::degrees(preset.tilt_deg);
    pavement.relief = preset.relief;
  }
  return pavement;
}

// A level body of 100 mm: 20 mm high, with arrises of 5 mm.
BodyDraws plain(Arris arris) {
  BodyDraws draws;
  draws.arris = arris;
  draws.arris_mm = 5.0;
  draws.rise_mm = 20.0;
  draws.tilt_room_mm = 100.0;
  return draws;
}

// The highest chance: a chip on each of the first six sides.
BodyDraws chipped(int sides) {
  BodyDraws draws = plain(Arris::rounded);
  draws.crown_mm = 3.0;
  draws.warp_mm = {0.7, -1.1};
  draws.slope = {0.01, -0.02};
  draws.chips_per_m = 1.0;
  for (int i = 0; i < sides; ++i) draws.chips[static_cast<std::size_t>(i)] = {0.0, 0.1 + 0.15 * i, 0.2 * i};
  return draws;
}

TEST(StoneBody, RoundedSquareIsFaceSidesAndCorners) {
  const std::vector<BezierPatch> patches = body_patches(square, plain(Arris::rounded), {});
  ASSERT_EQ(patches.size(), 9U);
  const BezierPatch& face = patches.back();
  EXPECT_NEAR(glm::length(face.at(0, 0) - vec3(5, 5, 20)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(face.at(3, 3) - vec3(95, 95, 20)), 0.0, 1e-12);
  EXPECT_EQ(seams(patches).size(), 12U);
  expect_smooth(patches);
}

TEST(StoneBody, CrownIsTheHeightOfTheMiddleOverTheMiddlesOfSides) {
  BodyDraws draws = plain(Arris::rounded);
  draws.crown_mm = 4.0;
  draws.arris_mm = 0.001;
  for (const Polygon& outline : {square, Polygon{{0, 0}, {300, 0}, {300, 50}, {0, 50}}}) {
    const BezierPatch face = body_patches(outline, draws, {}).back();
    EXPECT_NEAR(point(face, 0.5, 0.5).z, 24.0, 1e-9);
    EXPECT_NEAR(point(face, 0.5, 0.0).z, 20.0, 1e-3);
    EXPECT_NEAR(point(face, 0.0, 0.5).z, 20.0, 1e-3);
    EXPECT_NEAR(point(face, 0.0, 0.0).z, 16.0, 1e-3);
  }
}

TEST(StoneBody, WarpIsASaddleAndTiltAPlane) {
  BodyDraws draws = plain(Arris::rounded);
  draws.arris_mm = 0.001;
  draws.warp_mm = {2.0, 0.0};
  const BezierPatch saddle = body_patches(square, draws, {}).back();
  EXPECT_NEAR(point(saddle, 0.0, 0.5).z, 22.0, 1e-3);
  EXPECT_NEAR(point(saddle, 0.5, 0.0).z, 18.0, 1e-3);
  draws.warp_mm = {0.0, 0.0};
  draws.slope = {0.01, 0.02};
  const BezierPatch tilted = body_patches(square, draws, {}).back();
  EXPECT_NEAR(point(tilted, 1.0, 1.0).z, 20.0 + 0.5 + 1.0, 1e-3);
  draws.tilt_room_mm = 0.3;
  EXPECT_NEAR(point(body_patches(square, draws, {}).back(), 1.0, 1.0).z, 20.3, 1e-3);
}

TEST(StoneBody, ChamferIsAPlaneOfItsWidth) {
  const std::vector<BezierPatch> patches = body_patches(square, plain(Arris::chamfered), {});
  ASSERT_EQ(patches.size(), 9U);
  // Side 0: the steep strip, then the chamfer from 0.3 to 5.3 mm, which falls as far as it is wide.
  const BezierPatch& chamfer = patches[1];
  EXPECT_NEAR(point(chamfer, 0.5, 0.0).y, 0.3, 1e-9);
  EXPECT_NEAR(point(chamfer, 0.5, 0.0).z, 15.0, 1e-9);
  EXPECT_NEAR(point(chamfer, 0.5, 0.5).z, 17.5, 1e-9);
  EXPECT_NEAR(point(chamfer, 0.5, 1.0).y, 5.3, 1e-9);
  EXPECT_NEAR(point(chamfer, 0.5, 1.0).z, 20.0, 1e-9);
  EXPECT_LT(seam_errors(patches).distance_mm, 1e-9);
}

TEST(StoneBody, RoundedBodiesMeetSmoothlyWithChipsAndWithout) {
  for (const int count : {3, 4, 5, 6, 7}) {
    for (std::uint64_t number = 0; number < 25; ++number) {
      const Polygon outline = number == 0 ? regular(count, 55.0) : uneven(count, number);
      for (const int chips : {0, 1, 2, 4}) {
        const std::vector<BezierPatch> patches = body_patches(outline, chipped(chips), {});
        ASSERT_GE(patches.size(), 9U);
        // Every border of a patch is shared but for those along the outline, which lie at f = −rise, far below the face.
        std::size_t free = 0;
        for (const BezierPatch& patch : patches) {
          for (int border = 0; border < 4; ++border) {
            if (on_border(patch, border, 0.5).z < 10.0) ++free;
          }
        }
        EXPECT_EQ(2 * seams(patches).size() + free, 4 * patches.size()) << count << " corners, " << chips << " chips";
        expect_smooth(patches);
      }
    }
  }
}

TEST(StoneBody, SmoothnessTestSeesACrease) {
  std::vector<BezierPatch> patches = body_patches(square, chipped(1), {});
  patches.front().at(2, 2).z -= 0.01;
  EXPECT_GT(seam_errors(patches).normal, 1e-6);
}

// The lowest point of the surface within 0.3 mm of y = 2 mm: on the arris of side 0.
double lowest_on_arris(const std::vector<BezierPatch>& patches) {
  double lowest = 1e9;
  for (const BezierPatch& patch : patches) {
    for (double u = 0.0; u <= 1.0; u += 0.0625) {
      for (double v = 0.0; v <= 1.0; v += 0.0625) {
        const vec3 p = point(patch, u, v);
        if (std::abs(p.y - 2.0) < 0.3 && p.x > 10.0 && p.x < 90.0) lowest = std::min(lowest, p.z);
      }
    }
  }
  return lowest;
}

TEST(StoneBody, ChipsLowerTheArris) {
  BodyDraws draws = plain(Arris::rounded);
  draws.chips[0].chance = 0.0;
  draws.chips_per_m = 1.0;
  const double with = lowest_on_arris(body_patches(square, draws, {}));
  draws.chips_per_m = 0.0;
  EXPECT_LT(with, lowest_on_arris(body_patches(square, draws, {})) - 1.0);
}

TEST(StoneBody, SawnSidesAreSharpAndUnchipped) {
  const IsSawn first_side = [](vec2 a, vec2 b) { return a.y == 0.0 && b.y == 0.0; };
  BodyDraws draws = chipped(1);
  const std::vector<BezierPatch> patches = body_patches(square, draws, first_side);
  ASSERT_EQ(patches.size(), 9U);  // the chip was drawn for the side that was sawn
  EXPECT_NEAR(patches.back().at(0, 0).y, 1.5, 1e-9);
  EXPECT_NEAR(patches.back().at(0, 3).y, 95.0, 1e-9);
  expect_smooth(patches);
}

TEST(StoneBody, CoversTheStoneBelowTheBedAtItsOutline) {
  for (const FinishPreset& preset : finish_presets) {
    const Pavement pavement = finished(preset.body.finish);
    const double bed = bed_level_mm(pavement);
    for (int id = 0; id < 40; ++id) {
      const Polygon outline = uneven(3 + id % 6, static_cast<std::uint64_t>(id));
      const StoneDraws draws = stone_draws(pavement, 7, id);
      double top = 0.0;
      double area = 0.0;
      for (const BezierPatch& patch : surface_patches(outline, draws)) {
        for (double u = 0.0; u <= 1.0; u += 0.25) {
          for (double v = 0.0; v <= 1.0; v += 0.25) {
            const vec3 p = point(patch, u, v);
            top = std::max(top, p.z);
            EXPECT_TRUE(geometry::contains(outline, {p.x, p.y}) || p.z < bed) << preset.name;
          }
        }
        // Without chips and warp the border is where f is −rise: row or column 0 of patches along the outline.
        const auto corner = [&](std::size_t r, std::size_t c) { return vec2{patch.at(r, c).x, patch.at(r, c).y}; };
        area += 0.5 * (cross(corner(3, 0) - corner(0, 0), corner(3, 3) - corner(0, 0)) +
                       cross(corner(3, 3) - corner(0, 0), corner(0, 3) - corner(0, 0)));
      }
      EXPECT_NEAR(area / geometry::area(outline), 1.0, 0.03) << preset.name;
      EXPECT_LE(top, top_mm(pavement)) << preset.name;
      EXPECT_GT(top, bed) << preset.name;
    }
  }
}

TEST(StoneBody, OutlinesLieBelowTheBed) {
  for (const FinishPreset& preset : finish_presets) {
    const Pavement pavement = finished(preset.body.finish);
    for (int id = 0; id < 60; ++id) {
      const Polygon outline = uneven(3 + id % 6, 100 + static_cast<std::uint64_t>(id));
      for (const BezierPatch& patch : surface_patches(outline, stone_draws(pavement, 7, id))) {
        for (int border = 0; border < 4; ++border) {
          const vec3 p = on_border(patch, border, 0.4);
          double distance = 1e9;
          for (std::size_t i = 0; i < outline.size(); ++i) {
            const geometry::RegionIndex::Segment side{outline[i], outline[(i + 1) % outline.size()]};
            distance = std::min(distance, glm::length(nearest_point(side, {p.x, p.y}) - vec2{p.x, p.y}));
          }
          if (distance < 1e-9) {
            EXPECT_LT(p.z, bed_level_mm(pavement)) << preset.name;
          }
        }
      }
    }
  }
}

TEST(Wear, IsNothingAtTheBorderAndAllInTheMiddle) {
  Pavement pavement = finished(Finish::split);
  pavement.area.outline = {{0, 0}, {900, 0}, {900, 900}, {0, 900}};
  StoneLayout layout;
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) {
      Stone stone;
      stone.id = 9 * i + j;
      const vec2 low = {100.0 * i, 100.0 * j};
      stone.outline_mm = {low, low + vec2{100, 0}, low + vec2{100, 100}, low + vec2{0, 100}};
      layout.stones.push_back(stone);
    }
  }
  const std::vector<double> all = traffic(layout.stones, geometry::RegionIndex(pavement.area));
  EXPECT_EQ(all[40], 1.0);
  const double part = 50.0 / 450.0;
  EXPECT_NEAR(all[0], part * part * (3.0 - 2.0 * part), 1e-12);
  for (std::size_t k = 1; k < 5; ++k) EXPECT_GT(all[9 * k + 4], all[9 * (k - 1) + 4]);

  pavement.body.wear_mm = 6.0;
  const StoneDraws fresh = stone_draws(pavement, 7, 40);
  const StoneDraws old = worn(fresh, pavement, 1.0);
  EXPECT_EQ(old.sink_mm, fresh.sink_mm + 6.0);
  EXPECT_EQ(old.relief, 0.5);
  EXPECT_EQ(worn(fresh, pavement, 0.5).relief, 0.75);
  EXPECT_EQ(worn(fresh, pavement, 0.0).relief, 1.0);
  EXPECT_EQ(worn(fresh, pavement, 0.0).body->arris_mm, fresh.body->arris_mm);
}

TEST(Ground, SettlementIsSmoothAndWithinItsRange) {
  Ground ground;
  ground.settlement_mm = 30.0;
  ground.settlement_length_mm = 1000.0;
  double lowest = 0.0;
  double highest = -30.0;
  constexpr double step = 1e-3;
  for (int i = 0; i < 4000; ++i) {
    const vec2 place = {37.3 * i - 40'000.0, 11.7 * i - 9000.0};
    const GroundPoint here = settlement(ground, 5, place);
    lowest = std::min(lowest, here.height_mm);
    highest = std::max(highest, here.height_mm);
    const double along_x = settlement(ground, 5, place + vec2{step, 0.0}).height_mm - here.height_mm;
    const double along_y = settlement(ground, 5, place + vec2{0.0, step}).height_mm - here.height_mm;
    EXPECT_NEAR(along_x / step, here.slope.x, 1e-3);
    EXPECT_NEAR(along_y / step, here.slope.y, 1e-3);
  }
  EXPECT_GE(lowest, -30.0);
  EXPECT_LE(highest, 0.0);
  EXPECT_LT(lowest, -27.0);
  EXPECT_GT(highest, -3.0);
  EXPECT_EQ(settlement(Ground{}, 5, {100, 100}).height_mm, 0.0);
}

// Rows of stones of their length, or a little off it, from mitre to mitre.
TEST(Kerb, IsOfStonesOfItsLengthMitredAtCorners) {
  for (const double length_mm : {300.0, 900.0, 2000.0}) {
    Pavement pavement;
    pavement.name = "path";
    pavement.area.outline = {{0, 0}, {5000, 0}, {5000, 3000}, {0, 3000}};
    pavement.kerb = {120.0, length_mm, 0.0};
    const Pavement stones = kerb(pavement);
    const StoneLayout layout = laid_stones(stones, 7);
    EXPECT_EQ(faults(stones, layout).total(), 0U);
    double covered = 0.0;
    for (const Stone& stone : layout.stones) {
      const geometry::Box box = geometry::bounding_box(stone.outline_mm);
      const vec2 size = box.high - box.low;
      EXPECT_LT(std::min(size.x, size.y), 121.0) << "round the corner";
      EXPECT_NEAR(std::max(size.x, size.y), length_mm, 0.3 * length_mm + 120.0);
      covered += geometry::area(stone.outline_mm);
    }
    EXPECT_GT(covered, 0.925 * geometry::area(stones.area));
  }
}

TEST(Kerb, SurroundsThePavementAndRisesAsAsked) {
  for (const Finish finish : {Finish::none, Finish::split}) {
    Pavement pavement = finished(finish);
    pavement.area.outline = {{0, 0}, {3000, 0}, {3000, 2000}, {0, 2000}};
    pavement.kerb = {120.0, 800.0, 90.0};
    pavement.ground.fall_percent = 2.0;
    const Pavement stones = kerb(pavement);
    EXPECT_EQ(stones.name, "path_kerb");
    EXPECT_NEAR(geometry::area(stones.area), 3240.0 * 2240.0 - 3000.0 * 2000.0, 1.0);
    EXPECT_EQ(stones.ground.fall_percent, 2.0);
    // Level of its bed and of its faces, from those of the pavement.
    const double faces = finish == Finish::none ? 0.5625 * 18.0 : bed_level_mm(pavement) + pavement.surface.height_mm;
    EXPECT_NEAR(stones.ground.level_mm + bed_level_mm(stones), bed_level_mm(pavement), 1e-9);
    EXPECT_NEAR(stones.ground.level_mm + bed_level_mm(stones) + stones.surface.height_mm, faces + 90.0, 1e-9);
  }
}

}  // namespace
}  // namespace shatterpave::paving
