// Measured pavements in the report of `measure`.
#pragma once

#include <cstddef>
#include <string>

#include "measure/survey.h"
#include "report/json_values.h"

namespace shatterpave::reporting {

// Histograms and the map, as templates/report/measures_plots.js and templates/report/measures_map.js read them; numbers only.
Json pavement_data(const measure::SurveyedPavement& pavement);

// The section of the page about the scene's pavement number `index`: templates/report/measures_pavement.html, filled in.
std::string pavement_section(const measure::SurveyedPavement& pavement, std::size_t index);

}  // namespace shatterpave::reporting
