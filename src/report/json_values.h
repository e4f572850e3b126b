// Values of `measure` as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "measure/distribution.h"
#include "measure/finding.h"

namespace shatterpave::reporting {

using Json = nlohmann::ordered_json;

// The number; null for infinity, which JSON does not have.
Json number(double value);

// With target, figure and verdict; missing bounds, figures and errors are null.
Json json_of(const measure::Finding& finding);
Json json_of(const measure::Distribution& distribution);
Json json_of(const measure::Histogram& histogram);

}  // namespace shatterpave::reporting
