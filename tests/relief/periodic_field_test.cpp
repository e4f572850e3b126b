#include "relief/periodic_field.h"

#include <gtest/gtest.h>

#include "core/functions.h"

namespace shatterpave::relief {
namespace {

// `waves` sines along x over a side of 64 points, 1 mm apart.
HeightField sines(double waves) {
  HeightField field{64, 64, 1.0, {}};
  for (std::size_t row = 0; row < 64; ++row) {
    for (std::size_t column = 0; column < 64; ++column) {
      field.heights_mm.push_back(sine(2.0 * pi * waves * static_cast<double>(column) / 64.0));
    }
  }
  return field;
}

double largest_error(const PeriodicField& field, double waves) {
  double worst = 0.0;
  for (int k = 0; k < 997; ++k) {
    const double place = k / 997.0 + 3.0;  // periods
    const auto at = field.at(PeriodicField::phase(place), PeriodicField::phase(0.37 * k));
    worst = std::max(worst, std::abs(static_cast<double>(at) - sine(2.0 * pi * waves * place)));
  }
  return worst;
}

TEST(PeriodicField, IsTheFieldAtItsPoints) {
  const HeightField heights = sines(5.0);
  const PeriodicField field(heights, 1.0);
  ASSERT_EQ(field.size(), 64U);
  for (std::size_t column = 0; column < 64; ++column) {
    const auto at = field.at(PeriodicField::phase(static_cast<double>(column) / 64.0 - 2.0), 0);
    EXPECT_FLOAT_EQ(at, static_cast<float>(heights.heights_mm[column]));
  }
}

TEST(PeriodicField, LaysASmoothSurfaceThroughPointsThatAreFarApart) {
  // Straight lines between eight points of a wave err by (2π/8)² / 8 = 0.077; the smooth surface by a fraction of that.
  EXPECT_GT(largest_error(PeriodicField(sines(8.0), 1.0), 8.0), 0.05);
  const PeriodicField fine(sines(8.0), 0.1);
  EXPECT_GE(fine.size(), 256U);
  EXPECT_LT(largest_error(fine, 8.0), 0.02);
}

TEST(PeriodicField, LeavesOutWavesThatAreTooShort) {
  // Pixels of 8 mm: a wave of 2 points is gone, one of 64 points stays.
  const PeriodicField short_waves(sines(31.0), 8.0);
  EXPECT_LT(short_waves.size(), 64U);
  float highest = 0.0F;
  for (std::uint32_t k = 0; k < 64; ++k) highest = std::max(highest, std::abs(short_waves.at(k << 26U, 0)));
  EXPECT_LT(highest, 0.05F);
  EXPECT_LT(largest_error(PeriodicField(sines(1.0), 4.0), 1.0), 0.05);
}

TEST(PeriodicField, StepsMayGoBackwards) {
  const PeriodicField field(sines(3.0), 1.0);
  const std::uint32_t there = PeriodicField::phase(0.4);
  EXPECT_EQ(there + PeriodicField::phase_step(0.25) + PeriodicField::phase_step(-0.25), there);
}

}  // namespace
}  // namespace shatterpave::relief
