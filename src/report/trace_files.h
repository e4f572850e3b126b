// What `trace` writes: docs/trace.md tells what each file holds.
#pragma once

#include <string>
#include <vector>

#include "export/model.h"
#include "trace/trace.h"

namespace shatterpave::reporting {

// A pane that was traced. `name` is that of the photograph's file, without its ending.
struct TracedPane {
  std::string name;
  trace::Trace trace;
  int width_px = 0;  // of the photograph
  int height_px = 0;
};

// `NAME.json`: the pane as geometry (docs/scene-file.md), with the table `photograph`.
exporting::OutputFile trace_json(const TracedPane& traced);
// `NAME.csv`: turns along cracks that reach the edge, distances of rings from the impact, areas and shapes of pieces.
exporting::OutputFile trace_csv(const TracedPane& traced);
// `FIRST-trace.html`: each photograph with its lines, its figures, and those of the paper's panes of as many radial cracks.
exporting::OutputFile trace_report(const std::vector<TracedPane>& panes);

// `NAME-figures.csv`: of panes with given cracks, the figures that photograph, paper and generated panes have in common.
exporting::OutputFile figures_csv(const std::string& name, const std::vector<glass::Pane>& panes);

// `paper-table1.csv`: the nineteen panes of Agui et al. 1992, Table 1.
exporting::OutputFile experiment_csv();

}  // namespace shatterpave::reporting
