#include "relief/fractal_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "core/functions.h"
#include "core/parallel.h"
#include "relief/field_spectrum.h"
#include "relief/fourier.h"

namespace shatterpave::relief {
namespace {

FractalSurface small_surface(double hurst) { return {256, 0.5, 0.6, hurst, 64.0}; }

TEST(Fourier, EqualsTheSumItStandsFor) {
  constexpr std::size_t size = 8;
  std::vector<std::complex<double>> spectrum(size * size);
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    spectrum[i] = {normal(1, {Stream::relief_lattice, Id("a").child(i)}),
                   normal(2, {Stream::relief_lattice, Id("a").child(i)})};
  }
  std::vector<std::complex<double>> field = spectrum;
  transform_back(field, size);
  for (std::size_t y = 0; y < size; ++y) {
    for (std::size_t x = 0; x < size; ++x) {
      std::complex<double> sum = 0.0;
      for (std::size_t l = 0; l < size; ++l) {
        for (std::size_t k = 0; k < size; ++k) {
          sum += spectrum[l * size + k] * std::polar(1.0, 2.0 * pi * static_cast<double>(k * x + l * y) / size);
        }
      }
      EXPECT_NEAR(std::abs(field[y * size + x] - sum), 0.0, 1e-12);
    }
  }
}

// A ring holds some 2π · 0.25 ring² / 2 independent powers, each of relative deviation 1; from 6 waves on that is over 28, so
// its logarithm errs by 0.19 at most and the slope over a range of 1 : 20 by less than 0.1.
constexpr double slope_tolerance = 0.15;

TEST(FractalSurface, SpectrumFallsWithTheHurstExponent) {
  for (const double hurst : {0.2, 0.5, 0.7, 0.9}) {
    const double slope = spectral_slope(fractal_surface(small_surface(hurst), 7, Id("relief")), 6.0, 120.0);
    EXPECT_NEAR(slope, -(2.0 * hurst + 2.0), slope_tolerance) << "H = " << hurst;
    // The twin of a law that is 0.15 off in H must not pass.
    const double twin = spectral_slope(fractal_surface(small_surface(hurst - 0.15), 7, Id("relief")), 6.0, 120.0);
    EXPECT_GT(std::abs(twin + (2.0 * hurst + 2.0)), slope_tolerance) << "H = " << hurst;
  }
}

TEST(FractalSurface, HasTheAskedRootMeanSquare) {
  const HeightField field = fractal_surface(small_surface(0.7), 3, Id("relief"));
  EXPECT_NEAR(rms_mm(field), 0.6, 1e-12);
  double sum = 0.0;
  for (const double height : field.heights_mm) sum += height;
  EXPECT_NEAR(sum / static_cast<double>(field.heights_mm.size()), 0.0, 1e-12);
}

TEST(FractalSurface, WindowsOfTheLongestWaveShowMostOfTheHeight) {
  // What makes the roll-off: without it a window would keep little of the rms height of a large field.
  FractalSurface surface{512, 0.5, 1.0, 0.7, 64.0};
  const HeightField field = fractal_surface(surface, 5, Id("relief"));
  double squares = 0.0;
  int windows = 0;
  for (std::size_t top = 0; top < 512; top += 128, ++windows) {
    HeightField window{128, 128, 0.5, {}};
    for (std::size_t row = top; row < top + 128; ++row) {
      for (std::size_t column = 0; column < 128; ++column) window.heights_mm.push_back(field.at(column, row));
    }
    squares += rms_mm(window) * rms_mm(window);
  }
  EXPECT_GT(std::sqrt(squares / windows), 0.75);
}

TEST(FractalSurface, IsPeriodic) {
  // The step across the seam is as small as any other: a field that is not periodic jumps by about its rms there.
  const HeightField field = fractal_surface({256, 0.5, 1.0, 0.9, 64.0}, 7, Id("relief"));
  double seam = 0.0;
  double within = 0.0;
  for (std::size_t row = 0; row < 256; ++row) {
    seam += std::abs(field.at(0, row) - field.at(255, row));
    within += std::abs(field.at(100, row) - field.at(101, row));
  }
  EXPECT_LT(seam, 2.0 * within);
}

TEST(FractalSurface, IsTheSameForAnyNumberOfThreads) {
  HeightField one;
  {
    const ThreadLimit limit(1);
    one = fractal_surface(small_surface(0.7), 7, Id("relief"));
  }
  const ThreadLimit limit(7);
  EXPECT_EQ(one, fractal_surface(small_surface(0.7), 7, Id("relief")));
}

TEST(FractalSurface, NoRmsIsLevel) {
  const HeightField field = fractal_surface({16, 0.5, 0.0, 0.7, 4.0}, 7, Id("relief"));
  EXPECT_EQ(rms_mm(field), 0.0);
}

TEST(FractalSurface, SeedAndElementChangeIt) {
  const HeightField field = fractal_surface({16, 0.5, 1.0, 0.7, 4.0}, 7, Id("relief"));
  EXPECT_NE(field, fractal_surface({16, 0.5, 1.0, 0.7, 4.0}, 8, Id("relief")));
  EXPECT_NE(field, fractal_surface({16, 0.5, 1.0, 0.7, 4.0}, 7, Id("other")));
}

}  // namespace
}  // namespace shatterpave::relief
