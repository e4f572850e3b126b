// A survey of broken panes as files: docs/measure.md tells what each column and figure is.
#pragma once

#include <string>
#include <vector>

#include "export/model.h"
#include "measure/survey.h"

namespace shatterpave::reporting {

// `NAME-measures.csv`, `NAME-measures.json` and, if has_plots(), `NAME-measures.html`.
std::vector<exporting::OutputFile> measures_files(const measure::Survey& survey);

// One line for each impact of each pane and seed, after a line of names. Empty where there was nothing to measure.
std::string measures_csv(const measure::Survey& survey);

// The findings, each with target, figure and verdict; lines, distributions and histograms; the same of each pane of the scene.
std::string measures_json(const measure::Survey& survey);

// Whether the plotting library is part of this build, without which there is no report (cmake/plots.cmake).
bool has_plots();

// One page that needs nothing else: plots, findings and drawings of the first panes. Must not be called unless has_plots().
std::string measures_report(const measure::Survey& survey);

}  // namespace shatterpave::reporting
