// Elementary functions whose every bit is the same on every x86-64 processor.
//
// The C library chooses its sin, exp, pow … at run time by what the processor can do, and they differ in the last bit; growth
// of cracks is chaotic, so another last bit becomes another picture. These are SLEEF's functions without FMA (suffix purec,
// prefix cinz: "consistent, no FMA"), with at most 1 ulp of error. +, −, ×, ÷ and std::sqrt are exact by IEEE 754 and
// are used as they are. Nothing else in the project may call the C library's functions.
#pragma once

#include <numbers>

namespace shatterpave {

inline constexpr double pi = std::numbers::pi;

double sine(double radians);
double cosine(double radians);
struct SineAndCosine {
  double sine = 0.0;
  double cosine = 1.0;
};
// Both at once, at little more than the cost of one. The last bit may differ from that of the functions above.
SineAndCosine sine_and_cosine(double radians);
// The angle of (x, y) from +x, in (−pi, pi]; 0 for (0, 0).
double arctangent(double y, double x);
// For x in [−1, 1]; in [0, pi].
double arccosine(double x);
double exponential(double x);
// Natural logarithm; x > 0.
double logarithm(double x);
// x to the power y; x >= 0.
double power(double x, double y);

}  // namespace shatterpave
