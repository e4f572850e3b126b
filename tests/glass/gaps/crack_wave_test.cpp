#include "glass/gaps/crack_wave.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace shatterpave::glass {
namespace {

constexpr double step = 0.02;
constexpr int steps = 50'000;  // 1000 lengths of twist

struct Sides {
  double mean = 0.0;      // length between two changes of side
  double spread = 0.0;    // SD of that over its mean
  double steepest = 0.0;  // a length of 1
};

Sides sides_of(const std::function<double(double)>& wave) {
  Sides sides;
  std::vector<double> lengths;
  double last = 0.0;
  for (int i = 1; i < steps; ++i) {
    const double before = wave((i - 1) * step);
    const double here = wave(i * step);
    EXPECT_LE(std::abs(here), 1.0);
    sides.steepest = std::max(sides.steepest, std::abs(here - before) / step);
    if ((before < 0.0) == (here < 0.0)) continue;
    lengths.push_back(i * step - last);
    last = i * step;
  }
  for (const double length : lengths) sides.mean += length / static_cast<double>(lengths.size());
  for (const double length : lengths) sides.spread += (length - sides.mean) * (length - sides.mean);
  sides.spread = std::sqrt(sides.spread / static_cast<double>(lengths.size())) / sides.mean;
  return sides;
}

bool keeps_to_sides(const Sides& sides) {
  return sides.mean > 2.2 && sides.mean < 3.6 && sides.spread > 0.8 && sides.spread < 1.3 && sides.steepest < 3.0;
}

TEST(CrackWave, KeepsToOneSideOverStretchesOfManyLengths) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Sides sides = sides_of([&](double x) { return crack_wave(seed, Stream::crack_tilt, Id("crack"), x); });
    EXPECT_TRUE(keeps_to_sides(sides)) << sides.mean << ' ' << sides.spread << ' ' << sides.steepest;
  }
}

// The twins: twice as quick, and as even as a sine.
TEST(CrackWave, IsToldFromOneThatTwistsToABeat) {
  EXPECT_FALSE(keeps_to_sides(sides_of([](double x) { return crack_wave(1, Stream::crack_tilt, Id("crack"), 2.0 * x); })));
  EXPECT_FALSE(keeps_to_sides(sides_of([](double x) { return std::sin(1.1 * x); })));
}

TEST(CrackWave, IsAnotherForEachCrackAndSeed) {
  const double here = crack_wave(1, Stream::crack_tilt, Id("crack"), 5.3);
  EXPECT_NE(here, crack_wave(2, Stream::crack_tilt, Id("crack"), 5.3));
  EXPECT_NE(here, crack_wave(1, Stream::crack_tilt, Id("another"), 5.3));
  EXPECT_NE(here, crack_wave(1, Stream::crack_curve, Id("crack"), 5.3));
}

}  // namespace
}  // namespace shatterpave::glass
