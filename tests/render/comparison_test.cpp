#include "render/comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/functions.h"
#include "core/random.h"
#include "render/picture_row.h"

namespace shatterpave::render_tests {
namespace {

// The linear value that a screen shows as `shown`, above the straight part of the sRGB curve.
float linear(double shown) { return static_cast<float>(power((shown + 0.055) / 1.055, 2.4)); }

// Red rises by 0.1 a column from 0.1, green is 0.5 everywhere, blue is white with one black corner.
relief::Raster ramp() {
  relief::Raster raster{8, 4, 3, {}};
  for (std::size_t y = 0; y < 4; ++y) {
    for (std::size_t x = 0; x < 8; ++x) {
      raster.values.push_back(linear(0.1 * static_cast<double>(x + 1)));
      raster.values.push_back(linear(0.5));
      raster.values.push_back(x == 0 && y == 0 ? 0.0F : 100.0F);
    }
  }
  return raster;
}

double value(const std::vector<Statistic>& all, const std::string& region, char channel, Measure measure) {
  const auto found = std::ranges::find_if(
      all, [&](const Statistic& s) { return s.region == region && s.channel == channel && s.measure == measure; });
  EXPECT_NE(found, all.end()) << region;
  return found == all.end() ? -1.0 : found->value;
}

Case with_tolerance(double absolute) {
  Case of;
  of.grid = {2, 2};
  of.tolerances.fill({absolute, 0.0});
  return of;
}

relief::Raster noise(std::uint64_t seed, double middle, double spread) {
  relief::Raster raster{16, 16, 3, {}};
  const double level = middle + spread * normal(seed, {Stream::turn, Id("level"), 0});
  for (std::uint32_t i = 0; i < 16 * 16 * 3; ++i) {
    raster.values.push_back(linear(level + 0.02 * normal(seed, {Stream::turn, Id("pixel"), i})));
  }
  return raster;
}

std::vector<relief::Raster> series(std::uint64_t first_seed, double middle, double spread) {
  std::vector<relief::Raster> all;
  for (std::uint64_t i = 0; i < 8; ++i) all.push_back(noise(first_seed + i, middle, spread));
  return all;
}

TEST(PictureStatistics, AreThoseOfThePictureAsShown) {
  const std::vector<Statistic> all = statistics(ramp(), {2, 2});
  EXPECT_EQ(all.size(), 5U * 3U * measure_names.size());
  const double tolerance = 1e-6;  // of a float near 1
  EXPECT_NEAR(value(all, "whole", 'R', Measure::mean), 0.45, tolerance);
  EXPECT_NEAR(value(all, "whole", 'R', Measure::deviation), 0.1 * std::sqrt(63.0 / 12.0), tolerance);
  EXPECT_NEAR(value(all, "whole", 'R', Measure::percentile_5), 0.1, tolerance);
  EXPECT_NEAR(value(all, "whole", 'R', Measure::percentile_50), 0.4, tolerance);
  EXPECT_NEAR(value(all, "whole", 'R', Measure::percentile_95), 0.8, tolerance);
  EXPECT_NEAR(value(all, "whole", 'R', Measure::gradient), 0.1, tolerance);
  EXPECT_NEAR(value(all, "row 0, column 0", 'R', Measure::mean), 0.25, tolerance);
  EXPECT_NEAR(value(all, "row 1, column 1", 'R', Measure::percentile_25), 0.5, tolerance);
  EXPECT_NEAR(value(all, "whole", 'G', Measure::deviation), 0.0, tolerance);
  // A hundred times as bright as white is white, and the black corner is in one region alone.
  EXPECT_NEAR(value(all, "whole", 'B', Measure::mean), 31.0 / 32.0, tolerance);
  EXPECT_NEAR(value(all, "row 0, column 0", 'B', Measure::mean), 7.0 / 8.0, tolerance);
  EXPECT_NEAR(value(all, "row 0, column 1", 'B', Measure::mean), 1.0, tolerance);
  EXPECT_NEAR(value(all, "row 0, column 0", 'B', Measure::gradient), std::sqrt(2.0 / 3.0), tolerance);
}

TEST(PictureComparison, FindsASmallChangeInOneRegion) {
  relief::Raster changed = ramp();
  EXPECT_TRUE(compared(with_tolerance(0.001), ramp(), changed).agrees());
  // One green pixel of the last region, by 0.02 of white: 0.0025 of the region's mean, 0.0006 of the whole's.
  changed.values[(3 * 8 + 6) * 3 + 1] = linear(0.52);
  const Comparison comparison = compared(with_tolerance(0.002), ramp(), changed);
  EXPECT_FALSE(comparison.agrees());
  for (const Row& row : comparison.rows) {
    if (row.excess() > 0.0) {
      EXPECT_TRUE(row.what.starts_with("row 1, column 1, G") || row.what.starts_with("whole, G gradient") ||
                  row.what.starts_with("whole, G deviation"))
          << row.what;
    }
  }
  EXPECT_NE(comparison.table().find("out"), std::string::npos);
  EXPECT_TRUE(compared(with_tolerance(0.03), ramp(), changed).agrees());
}

TEST(PictureComparison, FindsNumbersThatAreNone) {
  relief::Raster changed = ramp();
  changed.values[1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(compared(with_tolerance(0.5), ramp(), changed).agrees());
}

TEST(PictureComparison, RefusesAnotherSize) {
  EXPECT_THROW(compared(with_tolerance(1.0), ramp(), {4, 8, 3, ramp().values}), std::runtime_error);
}

TEST(PictureComparison, OverSeedsAcceptsTheSameLawAndRejectsOthers) {
  Case of;
  of.seeds = Seeds{{}, {}, 4.6, 5.0};
  EXPECT_TRUE(compared_over_seeds(of, series(1, 0.5, 0.02), series(101, 0.5, 0.02)).agrees());
  EXPECT_FALSE(compared_over_seeds(of, series(1, 0.5, 0.02), series(101, 0.57, 0.02)).agrees()) << "another mean";
  EXPECT_FALSE(compared_over_seeds(of, series(1, 0.5, 0.02), series(101, 0.5, 0.0001)).agrees()) << "another spread";
}

TEST(PictureRow, GivesItsPartsBack) {
  const std::vector<relief::Raster> pictures = series(5, 0.4, 0.1);
  const relief::Raster row = row_of(pictures);
  EXPECT_EQ(row.width, 8U * 16U);
  EXPECT_EQ(parts_of(row, 16), pictures);
}

TEST(PictureRow, ShrinksByTheMean) {
  const relief::Raster small = shrunk({4, 2, 1, {1, 3, 0, 0, 5, 7, 0, 8}}, 2);
  EXPECT_EQ(small, (relief::Raster{2, 1, 1, {4, 2}}));
  EXPECT_EQ(shrunk(small, 1), small);
}

}  // namespace
}  // namespace shatterpave::render_tests
