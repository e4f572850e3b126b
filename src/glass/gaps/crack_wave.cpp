#include "glass/gaps/crack_wave.h"

#include <algorithm>
#include <cmath>

#include "core/smooth_step.h"

namespace shatterpave::glass {

namespace {

// By how much of the distance of two knots each is off an even row of them: else walls twist to a beat, which no crack does.
constexpr double unevenness = 0.6;
// Knots of an octave by number, each with draws for its place and its value.
constexpr unsigned knot_bits = 29;

// In [-1, 1], smooth, another value about a length of 1 on; x >= 0.
double octave(std::uint64_t seed, Stream stream, const Id& crack, std::uint32_t number, double x) {
  const auto draw = [&](std::uint32_t what, double knot) {
    return uniform(seed, {stream, crack, ((2 * number + what) << knot_bits) + static_cast<std::uint32_t>(knot)});
  };
  const auto place = [&](double knot) { return knot + unevenness * draw(0, knot); };
  const auto value = [&](double knot) { return 2.0 * draw(1, knot) - 1.0; };
  const double from_first = x + 1.0;  // the first knot lies before x = 0
  double knot = std::floor(from_first);
  if (place(knot) > from_first) knot -= 1.0;
  const double part = (from_first - place(knot)) / (place(knot + 1.0) - place(knot));
  return value(knot) + smooth_step(part) * (value(knot + 1.0) - value(knot));
}

}  // namespace

double crack_wave(std::uint64_t seed, Stream stream, const Id& crack, double x) {
  constexpr double stretch = 2.7;
  constexpr double gain = 1.12;  // else three octaves together would seldom come near 1
  const double sum = 0.62 * octave(seed, stream, crack, 0, x / stretch) + 0.29 * octave(seed, stream, crack, 1, x) +
                     0.09 * octave(seed, stream, crack, 2, 3.0 * x);
  return std::clamp(gain * sum, -1.0, 1.0);
}

}  // namespace shatterpave::glass
