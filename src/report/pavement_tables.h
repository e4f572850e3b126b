// Measured pavements as tables and JSON: docs/measure.md tells what each column and figure is.
#pragma once

#include <string>

#include "measure/survey.h"
#include "report/json_values.h"

namespace shatterpave::reporting {

// One line for each seed and pavement, after a line of names. Empty where there was nothing to measure.
std::string pavements_csv(const measure::Survey& survey);

// One line for each stone of each pavement, as set out with the first seed.
std::string stones_csv(const measure::Survey& survey);

// The findings of all seeds, each with target, figure and verdict; figures, histograms and holes of the first seed; spread of
// the figures over the seeds.
Json pavement_json(const measure::SurveyedPavement& pavement);

}  // namespace shatterpave::reporting
