#include "core/functions.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>

#include "core/random.h"

namespace shatterpave {
namespace {

constexpr std::uint32_t tries = 20000;

double drawn(std::uint32_t i, std::uint32_t which, double low, double high) {
  return low + (high - low) * uniform(1, {Stream::turn, Id("argument").child(which), i});
}

// The distance of `value` from the true one, in units of the last place of the true one.
double error_ulp(double value, long double truth) {
  const double nearest = std::abs(static_cast<double>(truth));
  const double ulp = std::max(std::nextafter(nearest, HUGE_VAL) - nearest, std::numeric_limits<double>::denorm_min());
  return static_cast<double>(std::abs(static_cast<long double>(value) - truth) / static_cast<long double>(ulp));
}

void expect_within_an_ulp(double low, double high, const std::function<double(double)>& ours,
                          const std::function<long double(long double)>& oracle) {
  double worst = 0.0;
  for (std::uint32_t i = 0; i < tries; ++i) {
    const double x = drawn(i, 0, low, high);
    worst = std::max(worst, error_ulp(ours(x), oracle(static_cast<long double>(x))));
  }
  EXPECT_LE(worst, 1.0);
  EXPECT_GT(worst, 0.3) << "an error this small means that nothing was compared";
}

// Against the C library in long double, whose own error is a thousandth of that.
TEST(Functions, AreWithinOneUnitInTheLastPlace) {
  expect_within_an_ulp(-100.0, 100.0, sine, [](long double x) { return std::sin(x); });
  expect_within_an_ulp(-100.0, 100.0, cosine, [](long double x) { return std::cos(x); });
  expect_within_an_ulp(-1.0, 1.0, arccosine, [](long double x) { return std::acos(x); });
  expect_within_an_ulp(-50.0, 50.0, exponential, [](long double x) { return std::exp(x); });
  expect_within_an_ulp(1e-9, 1e4, logarithm, [](long double x) { return std::log(x); });
}

TEST(Functions, OfTwoArgumentsAreWithinOneUnitInTheLastPlace) {
  double worst_power = 0.0;
  double worst_angle = 0.0;
  for (std::uint32_t i = 0; i < tries; ++i) {
    const double x = drawn(i, 1, 0.0, 20.0);
    const double y = drawn(i, 2, -10.0, 10.0);
    const auto long_x = static_cast<long double>(x);
    const auto long_y = static_cast<long double>(y);
    worst_power = std::max(worst_power, error_ulp(power(x, y), std::pow(long_x, long_y)));
    worst_angle = std::max(worst_angle, error_ulp(arctangent(y, x - 10.0), std::atan2(long_y, long_x - 10.0L)));
  }
  EXPECT_LE(worst_power, 1.0);
  // x - 10 rounds once in double, and not in long double: half a unit of its argument beside the function's own.
  EXPECT_LE(worst_angle, 1.0);
}

TEST(Functions, AtTheirLimits) {
  EXPECT_EQ(arctangent(0.0, 0.0), 0.0);
  EXPECT_EQ(arctangent(0.0, -1.0), pi);
  EXPECT_EQ(arctangent(1.0, 0.0), pi / 2.0);
  EXPECT_EQ(arccosine(1.0), 0.0);
  EXPECT_EQ(arccosine(-1.0), pi);
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_EQ(logarithm(1.0), 0.0);
  EXPECT_EQ(power(0.0, 0.0), 1.0);
  EXPECT_EQ(power(0.0, 2.0), 0.0);
}

}  // namespace
}  // namespace shatterpave
