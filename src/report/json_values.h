// Values of `measure` as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "measure/distribution.h"
#include "measure/finding.h"

namespace shatterpave::reporting {

using Json = nlohmann::ordered_json;

// JSON has no infinity: null.
Json number(double value);

// With target, figure and verdict; a bound, figure or error that there is not is null.
Json json_of(const measure::Finding& finding);
Json json_of(const measure::Distribution& distribution);
Json json_of(const measure::Histogram& histogram);

}  // namespace shatterpave::reporting
