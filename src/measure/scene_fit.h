// A pane of a scene whose panes, over many seeds, could be those that were traced.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "glass/pane.h"
#include "measure/pane_figures.h"

namespace shatterpave::measure {

// A value of the scene that was fitted.
struct FittedValue {
  std::string_view key;  // as in a scene file, from the pane on
  double value = 0.0;
  double error = 0.0;  // standard error
};

// How a figure of the traced panes stands beside panes of the scene with other seeds than it was fitted with.
struct FigureFit {
  std::string_view figure;
  double traced = 0.0;     // mean over the traced panes
  double mean = 0.0;       // over seeds
  double deviation = 0.0;  // of one pane
};

struct SceneFit {
  glass::Pane pane;
  std::vector<FittedValue> values;
  std::vector<FigureFit> figures;
  // The share of panes of the scene that are as far from its mean as the traced ones, or farther: below 0.05 these are hardly
  // of its kind.
  double probability = 0.0;
};

// By simulated moments: each value is changed until the figure that follows from it has the mean of the traced panes over the
// same seeds, four rounds of them; so for both patterns, of which the nearer one is taken.
//   traced  figures of one pane or more
//   like    outline, thickness and place of the impact; the rest of it is not looked at
// The same for the same arguments, on any number of threads. Some ten seconds.
SceneFit fitted_scene(const std::vector<PaneFigures>& traced, const glass::Pane& like, const Progress& progress = {});

}  // namespace shatterpave::measure
