#include "export/textures/surface_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "export/textures/texture_scenes.h"
#include "geometry/region_index.h"
#include "paving/surface/stone_surface.h"
#include "relief/field_spectrum.h"

namespace shatterpave::exporting::textures {
namespace {

// The height of the patch over `at`, by Newton's method from several starts; nothing where it does not lie over it.
std::optional<double> height_over(const geometry::BezierPatch& patch, vec2 at) {
  for (const vec2 start : {vec2{0.5, 0.5}, vec2{0.1, 0.1}, vec2{0.9, 0.1}, vec2{0.1, 0.9}, vec2{0.9, 0.9}}) {
    vec2 uv = start;
    for (int step = 0; step < 60; ++step) {
      const vec3 p = geometry::point(patch, uv.x, uv.y);
      const vec3 du = geometry::derivative_u(patch, uv.x, uv.y);
      const vec3 dv = geometry::derivative_v(patch, uv.x, uv.y);
      const double det = du.x * dv.y - du.y * dv.x;
      if (std::abs(det) < 1e-12) break;
      const vec2 miss = at - vec2{p.x, p.y};
      if (glm::length(miss) < 1e-9) break;
      uv += vec2{miss.x * dv.y - miss.y * dv.x, du.x * miss.y - du.y * miss.x} / det;
      uv = glm::clamp(uv, vec2{-0.01, -0.01}, vec2{1.01, 1.01});
    }
    const vec3 p = geometry::point(patch, uv.x, uv.y);
    const bool within = uv.x >= -1e-9 && uv.x <= 1.0 + 1e-9 && uv.y >= -1e-9 && uv.y <= 1.0 + 1e-9;
    if (within && glm::length(at - vec2{p.x, p.y}) < 1e-6) return p.z;
  }
  return std::nullopt;
}

std::optional<double> height_of_stone(const Drawn& drawn, const paving::Stone& stone, vec2 at) {
  std::optional<double> highest;
  for (const auto& patch :
       paving::surface_patches(stone.outline_mm, paving::stone_draws(drawn.pavement, drawn.surface.seed, stone.id))) {
    const auto height = height_over(patch, at);
    if (height && (!highest || *height > *highest)) highest = height;
  }
  return highest;
}

// How far `height_mm` is from the heights that the stone has within `reach_mm` of `at`, where it has `there_mm`: near corners
// of a stone the patch is so steep that a hair to the side is millimetres down.
double error_near(const Drawn& drawn, const paving::Stone& stone, vec2 at, double there_mm, double height_mm, double reach_mm) {
  double low = there_mm;
  double high = there_mm;
  if (std::abs(height_mm - there_mm) < 0.5) return std::abs(height_mm - there_mm);  // no need to look
  for (const vec2 to : {vec2{1.0, 0.0}, vec2{-1.0, 0.0}, vec2{0.0, 1.0}, vec2{0.0, -1.0}}) {
    const auto beside = height_of_stone(drawn, stone, at + reach_mm * to);
    low = std::min(low, beside.value_or(low));
    high = std::max(high, beside.value_or(high));
  }
  return std::max({0.0, low - height_mm, height_mm - high});
}

struct Agreement {
  int stones = 0;    // pixels that are a stone's in both
  int joints = 0;    // in neither
  int missed = 0;    // that should be of another stone, or, farther from it than a tenth of a pixel, of none
  double worst = 0;  // mm that heights are away from those of the stones within a tenth of a pixel
};

bool is_within_of(const geometry::Polygon& outline, vec2 at, double reach_mm) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const vec2 nearest =
        geometry::nearest_point(geometry::RegionIndex::Segment{outline[i], outline[(i + 1) % outline.size()]}, at);
    if (glm::length(nearest - at) <= reach_mm) return true;
  }
  return false;
}

// Against what stands in the outlines of `stones`, point by point. A pixel whose stone stands within `margin_mm` of the bed may
// be either.
Agreement agreement(const Drawn& drawn, const std::vector<paving::Stone>& stones) {
  constexpr double margin_mm = 2.0;
  const double bed = paving::bed_level_mm(drawn.pavement.surface);
  const double reach = 0.1 * drawn.map.grid.pixel_mm.x;
  Agreement result;
  for (std::size_t row = 0; row < drawn.map.grid.height; ++row) {
    for (std::size_t column = 0; column < drawn.map.grid.width; ++column) {
      const vec2 at = drawn.map.grid.centre(static_cast<double>(column), static_cast<double>(row));
      const auto found =
          std::ranges::find_if(stones, [&](const auto& stone) { return geometry::contains(stone.outline_mm, at); });
      const std::uint32_t drawn_stone = drawn.map.stone[drawn.map.index(column, row)];
      if (found == stones.end()) {
        const bool joint = drawn_stone == 0 || is_within_of(stones[drawn_stone - 1].outline_mm, at, reach);
        (joint ? result.joints : result.missed) += 1;
        continue;
      }
      const auto height = height_of_stone(drawn, *found, at);
      if (!height || *height < bed + margin_mm) continue;
      const bool same = drawn_stone == static_cast<std::uint32_t>(found - stones.begin()) + 1;
      (same ? result.stones : result.missed) += 1;
      if (!same) continue;
      const auto drawn_height = static_cast<double>(drawn.map.height_mm[drawn.map.index(column, row)]);
      result.worst = std::max(result.worst, error_near(drawn, *found, at, *height, drawn_height, reach));
    }
  }
  return result;
}

paving::Pavement smooth_ring() {
  paving::Pavement pavement = square_pavement(700.0);
  pavement.direction = paving::RadialDirection{{-250.0, -150.0}};
  pavement.relief.rms_mm = 0.0;
  return pavement;
}

TEST(SurfaceMap, IsTheStonesPointByPoint) {
  const paving::Pavement pavement = smooth_ring();
  const auto stones = paving::laid_stones(pavement, 7).stones;
  const Drawn drawn(pavement, stones, {{0.0, 0.0}, {5.0, 5.0}, 140, 140}, 1);
  const Agreement found = agreement(drawn, stones);
  EXPECT_EQ(found.missed, 0);
  EXPECT_GT(found.stones, 13000);
  EXPECT_GT(found.joints, 1500);
  // What chords of triangles of a pixel's size are off the curve of a corner.
  EXPECT_LT(found.worst, 0.5);

  // The twin: the same stones a quarter of a joint and more to the side.
  auto moved = stones;
  for (auto& stone : moved) {
    for (vec2& p : stone.outline_mm) p.x += 5.0;
  }
  EXPECT_GT(agreement(drawn, moved).missed, 300);
}

TEST(SurfaceMap, FinerPixelsComeNearerToThePatches) {
  const paving::Pavement pavement = smooth_ring();
  const auto stones = paving::laid_stones(pavement, 7).stones;
  const Drawn fine(pavement, stones, {{200.0, 200.0}, {1.0, 1.0}, 120, 120}, 1);
  const Agreement found = agreement(fine, stones);
  EXPECT_EQ(found.missed, 0);
  EXPECT_LT(found.worst, 0.1);
}

TEST(SurfaceMap, PixelsAreTheMeanOfTheirSamples) {
  const paving::Pavement pavement = square_pavement(400.0);
  const auto stones = paving::laid_stones(pavement, 7).stones;
  const Drawn coarse(pavement, stones, {{0.0, 0.0}, {4.0, 4.0}, 100, 100}, 4, false, 0);
  const Drawn fine(pavement, stones, {{0.0, 0.0}, {1.0, 1.0}, 400, 400}, 1, false, 0);
  int partly = 0;
  for (std::size_t row = 0; row < 100; ++row) {
    for (std::size_t column = 0; column < 100; ++column) {
      double sum = 0.0;
      double covered = 0.0;
      for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t i = 0; i < 4; ++i) {
          sum += static_cast<double>(fine.map.height_mm[fine.map.index(4 * column + i, 4 * row + j)]);
          covered += fine.map.stone[fine.map.index(4 * column + i, 4 * row + j)] == 0 ? 0.0 : 1.0;
        }
      }
      const std::size_t at = coarse.map.index(column, row);
      // Floats of up to 15 mm; samples of both maps are the same but for roundings of their places.
      ASSERT_NEAR(static_cast<double>(coarse.map.height_mm[at]), sum / 16.0, 0.01);
      ASSERT_NEAR(static_cast<double>(coarse.map.cover[at]), 255.0 * covered / 16.0, 16.5);
      if (covered > 0.0 && covered < 16.0) ++partly;
    }
  }
  EXPECT_GT(partly, 500);
}

TEST(SurfaceMap, IsTheSameForAnyNumberOfThreads) {
  const paving::Pavement pavement = square_pavement(600.0);
  const auto stones = paving::laid_stones(pavement, 7).stones;
  const PixelGrid grid{{0.0, 0.0}, {4.0, 4.0}, 150, 150};
  std::vector<SurfaceMap> maps;
  for (const int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    maps.push_back(Drawn(pavement, stones, grid, 2).map);
  }
  for (const SurfaceMap& map : maps) {
    EXPECT_EQ(map.height_mm, maps.front().height_mm);
    EXPECT_EQ(map.stone, maps.front().stone);
    EXPECT_EQ(map.cover, maps.front().cover);
  }
}

// The surface of a stone without a crown that is larger than a period of the relief, over exactly one period.
relief::HeightField surface_of_large_stone(double rms_mm, double hurst) {
  paving::Pavement pavement = square_pavement(1000.0);
  pavement.surface.height_mm = 0.0;
  pavement.relief = {rms_mm, hurst};
  const std::vector<paving::Stone> stone = {
      {0, paving::StoneKind::whole, {{0.0, 0.0}, {800.0, 0.0}, {800.0, 800.0}, {0.0, 800.0}}, {}}};
  constexpr std::size_t size = 512;
  const double side_mm = fields_for(pavement).relief_side_mm;
  const Drawn drawn(pavement, stone, {{100.0, 100.0}, {side_mm / size, side_mm / size}, size, size}, 2);
  relief::HeightField field{size, size, side_mm / size, {}};
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column) {
      EXPECT_EQ(drawn.map.stone[drawn.map.index(column, row)], 1U);
      field.heights_mm.push_back(static_cast<double>(drawn.map.height_mm[drawn.map.index(column, row)]));
    }
  }
  return field;
}

// Without what the stone's own tilt makes of it.
relief::HeightField relief_on_level_stone(double rms_mm, double hurst) {
  static const relief::HeightField smooth = surface_of_large_stone(0.0, 0.5);
  relief::HeightField field = surface_of_large_stone(rms_mm, hurst);
  for (std::size_t i = 0; i < field.heights_mm.size(); ++i) field.heights_mm[i] -= smooth.heights_mm[i];
  return field;
}

// As in the tests of the fractal surface. What pixels are too coarse for is a twentieth of the rms at H = 0.5, and less beyond.
TEST(SurfaceMap, ReliefOnAStoneHasTheAskedSpectrumAndRms) {
  for (const double hurst : {0.5, 0.8}) {
    const double asked = -(2.0 * hurst + 2.0);
    const relief::HeightField field = relief_on_level_stone(0.6, hurst);
    EXPECT_NEAR(relief::spectral_slope(field, 8.0, 80.0), asked, 0.15) << hurst;
    EXPECT_NEAR(rms_mm(field), 0.6, 0.03) << hurst;
    // The twins, a little off in either, here and below.
    EXPECT_GT(std::abs(relief::spectral_slope(relief_on_level_stone(0.6, hurst - 0.15), 8.0, 80.0) - asked), 0.15) << hurst;
  }
  EXPECT_GT(std::abs(rms_mm(relief_on_level_stone(0.66, 0.8)) - 0.6), 0.03);
}

// Mean step of the heights from one column to the next, across the seam over within.
double seam_over_inside(const Drawn& drawn) {
  const PixelGrid& grid = drawn.map.grid;
  double seam = 0.0;
  double inside = 0.0;
  const auto height = [&](std::size_t column, std::size_t row) {
    return static_cast<double>(drawn.map.height_mm[drawn.map.index(column, row)]);
  };
  for (std::size_t row = 0; row < grid.height; ++row) {
    seam += std::abs(height(0, row) - height(grid.width - 1, row));
    for (std::size_t column = 1; column < grid.width; ++column) {
      inside += std::abs(height(column, row) - height(column - 1, row)) / static_cast<double>(grid.width - 1);
    }
  }
  return seam / inside;
}

PixelGrid pixels_over(vec2 size_mm, std::size_t width, std::size_t height) {
  return {{0.0, 0.0}, size_mm / vec2{static_cast<double>(width), static_cast<double>(height)}, width, height};
}

// ---- stones as they lie

std::vector<float> heights(const paving::Pavement& pavement, const std::vector<paving::Stone>& stones) {
  return Drawn(pavement, stones, {{0.0, 0.0}, {4.0, 4.0}, 250, 250}, 1).map.height_mm;
}

// The mean of `after` less `before` over the window's square of that many pixels about a pixel.
double mean_rise(const std::vector<float>& before, const std::vector<float>& after, std::size_t column, std::size_t row) {
  double sum = 0.0;
  for (std::size_t j = row - 8; j < row + 8; ++j) {
    for (std::size_t i = column - 8; i < column + 8; ++i) {
      const std::size_t at = (j + 1) * 252 + i + 1;
      sum += static_cast<double>(after[at]) - static_cast<double>(before[at]);
    }
  }
  return sum / 256.0;
}

TEST(SurfaceMap, StonesAreWornInTheMiddleAndNotAtTheBorder) {
  paving::Pavement pavement = square_pavement(1000.0);
  pavement.stone_mm = {200.0, 200.0};
  pavement.body.finish = paving::Finish::split;
  pavement.relief.rms_mm = 0.0;
  const auto stones = paving::laid_stones(pavement, 7).stones;
  const auto before = heights(pavement, stones);
  pavement.body.wear_mm = 6.0;
  const auto after = heights(pavement, stones);
  EXPECT_NEAR(mean_rise(before, after, 125, 125), -6.0, 1.5);
  EXPECT_NEAR(mean_rise(before, after, 12, 125), 0.0, 1.0);
}

TEST(SurfaceMap, StonesAndJointsSinkWithTheGround) {
  paving::Pavement pavement = square_pavement(1000.0);
  pavement.relief.rms_mm = 0.0;
  const auto stones = paving::laid_stones(pavement, 7).stones;
  const auto before = heights(pavement, stones);
  pavement.ground.settlement_mm = 40.0;
  pavement.ground.settlement_length_mm = 900.0;
  const auto after = heights(pavement, stones);
  const auto off = [&](double factor) {
    double worst = 0.0;
    for (const std::size_t row : {30U, 90U, 160U, 220U}) {
      for (const std::size_t column : {25U, 100U, 150U, 225U}) {
        const vec2 at{4.0 * (static_cast<double>(column)), 1000.0 - 4.0 * static_cast<double>(row)};
        const double sunk = paving::settlement(pavement.ground, 7, at).height_mm;
        worst = std::max(worst, std::abs(mean_rise(before, after, column, row) - factor * sunk));
      }
    }
    return worst;
  };
  EXPECT_LT(off(1.0), 1.0);  // the ground bends within a stone, which does not
  EXPECT_GT(off(0.8), 4.0);  // the twin
}

// Grains are so wide in mm, whatever the pixels: between pixels a tenth as far apart the sand rises by a tenth, or less where
// it is smooth.
TEST(SurfaceMap, SandIsSmoothWherePixelsAreFinerThanItsGrains) {
  paving::Pavement pavement = square_pavement(1000.0);
  pavement.joint_mm = 200.0;
  const auto stones = paving::laid_stones(pavement, 7).stones;
  const auto mean_step = [&](double pixel_mm) {
    const Drawn drawn(pavement, stones, {{2.0, 2.0}, {pixel_mm, pixel_mm}, 64, 64}, 1);
    double sum = 0.0;
    for (std::size_t row = 0; row < 64; ++row) {
      for (std::size_t column = 0; column + 1 < 64; ++column) {
        const std::size_t at = drawn.map.index(column, row);
        EXPECT_EQ(drawn.map.stone[at], 0U);
        sum += static_cast<double>(std::abs(drawn.map.height_mm[at + 1] - drawn.map.height_mm[at]));
      }
    }
    return sum / (64.0 * 63.0);
  };
  const double coarse = mean_step(0.2);
  EXPECT_GT(coarse, 0.01);
  EXPECT_LT(mean_step(0.02), 0.15 * coarse);
}

TEST(SurfaceMap, SeamlessTileMeetsItself) {
  paving::Pavement pavement = square_pavement(1000.0);
  pavement.bonding.bond = paving::Bond::running;
  pavement.stone_mm = {210.0, 100.0};
  pavement.textures.tile_mm = vec2{860.0, 640.0};
  // Whose hollows are not as far apart as the tile is wide.
  pavement.ground.settlement_mm = 10.0;
  pavement.ground.settlement_length_mm = 350.0;
  pavement.body.wear_mm = 2.0;
  const paving::SeamlessTile tile = paving::seamless_tile(pavement, 7);
  const PixelGrid grid = pixels_over(tile.size_mm, 172, 128);
  const Drawn drawn(pavement, tile.layout.stones, grid, 2, true, 4);
  // What is drawn beyond the tile is the tile again.
  std::size_t other = 0;
  for (std::size_t row = 0; row < drawn.map.rows(); ++row) {
    for (std::size_t column = 0; column < drawn.map.row_length(); ++column) {
      const std::size_t wrapped =
          drawn.map.index((column + grid.width - 4) % grid.width, (row + grid.height - 4) % grid.height);
      const std::size_t at = row * drawn.map.row_length() + column;
      if (drawn.map.stone[at] != drawn.map.stone[wrapped]) ++other;
      ASSERT_NEAR(drawn.map.height_mm[at], drawn.map.height_mm[wrapped], 0.2F);
    }
  }
  EXPECT_LE(other, 4U);  // places that round differently a tile farther on
  // A seam goes through stones and joints as other columns do, but through its own ones.
  EXPECT_LT(seam_over_inside(drawn), 1.5);

  // The twin: a window that is no tile.
  const Drawn cut(pavement, paving::laid_stones(pavement, 7).stones, pixels_over({500.0, 640.0}, 100, 128), 2);
  EXPECT_GT(seam_over_inside(cut), 1.5);
}

}  // namespace
}  // namespace shatterpave::exporting::textures
