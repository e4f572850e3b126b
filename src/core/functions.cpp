#include "core/functions.h"

#include <sleef.h>

namespace shatterpave {

double sine(double radians) { return Sleef_cinz_sind1_u10purec(radians); }
double cosine(double radians) { return Sleef_cinz_cosd1_u10purec(radians); }
SineAndCosine sine_and_cosine(double radians) {
  const Sleef_double_2 both = Sleef_cinz_sincosd1_u10purec(radians);
  return {both.x, both.y};
}
double arctangent(double y, double x) { return x == 0.0 && y == 0.0 ? 0.0 : Sleef_cinz_atan2d1_u10purec(y, x); }
double arccosine(double x) { return Sleef_cinz_acosd1_u10purec(x); }
double exponential(double x) { return Sleef_cinz_expd1_u10purec(x); }
double logarithm(double x) { return Sleef_cinz_logd1_u10purec(x); }
double power(double x, double y) { return Sleef_cinz_powd1_u10purec(x, y); }

}  // namespace shatterpave
