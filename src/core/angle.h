// An angle that cannot be mistaken for a number: degrees and radians look alike.
#pragma once

#include <compare>

#include "core/functions.h"
#include "core/vec.h"

namespace shatterpave {

class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle radians(double value) { return Angle(value); }
  static constexpr Angle degrees(double value) { return Angle(value * (pi / 180.0)); }
  // The direction of `v` from +x, in (−180°, 180°]; 0 for the zero vector.
  static Angle of(vec2 v);

  constexpr double radians() const { return radians_; }
  constexpr double degrees() const { return radians_ * (180.0 / pi); }
  // (cos, sin): the unit vector at this angle from +x.
  vec2 direction() const;
  // The same direction within (−180°, 180°].
  Angle wrapped() const;

  constexpr auto operator<=>(const Angle&) const = default;
  constexpr Angle operator-() const { return Angle(-radians_); }
  friend constexpr Angle operator+(Angle a, Angle b) { return Angle(a.radians_ + b.radians_); }
  friend constexpr Angle operator-(Angle a, Angle b) { return Angle(a.radians_ - b.radians_); }
  friend constexpr Angle operator*(Angle a, double k) { return Angle(a.radians_ * k); }
  friend constexpr Angle operator*(double k, Angle a) { return a * k; }

 private:
  explicit constexpr Angle(double value) : radians_(value) {}
  double radians_ = 0.0;
};

// `v` turned counter-clockwise by `angle`.
vec2 rotated(vec2 v, Angle angle);

}  // namespace shatterpave
