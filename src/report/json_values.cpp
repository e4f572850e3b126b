#include "report/json_values.h"

#include <cmath>

#include "report/words.h"

namespace shatterpave::reporting {

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const measure::Finding& f) {
  return {{"id", f.id},
          {"quantity", f.quantity},
          {"unit", f.unit},
          {"low", number(f.low)},
          {"high", number(f.high)},
          {"figure", f.count > 0 ? number(f.figure) : Json(nullptr)},
          {"standard_error", f.error > 0.0 ? number(f.error) : Json(nullptr)},
          {"count", f.count},
          {"counted", f.counted},
          {"verdict", word_of(f.verdict)}};
}

Json json_of(const measure::Distribution& d) {
  return {{"count", d.count()}, {"mean", d.mean()}, {"sd", d.deviation()}, {"min", d.least()}, {"max", d.greatest()}};
}

Json json_of(const measure::Histogram& h) { return {{"low", h.low}, {"width", h.width}, {"counts", h.counts}}; }

}  // namespace shatterpave::reporting
