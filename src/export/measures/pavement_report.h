// Measured pavements in the report of `measure`.
#pragma once

#include <cstddef>
#include <string>

#include "export/measures/json_values.h"
#include "measure/survey.h"

namespace shatterpave::exporting {

// Histograms and the map, as templates/measures_plots.js and templates/measures_map.js read them; numbers only.
Json pavement_data(const measure::SurveyedPavement& pavement);

// The section of the page about the scene's pavement number `index`: templates/measures_pavement.html, filled in.
std::string pavement_section(const measure::SurveyedPavement& pavement, std::size_t index);

}  // namespace shatterpave::exporting
