#include "measure/experiment.h"

#include <array>
#include <vector>

namespace shatterpave::measure {

std::span<const ExperimentPane> experiment_panes() {
  static constexpr std::array<ExperimentPane, 19> panes = {{
      {70, 9, 80.24},   {113, 9, 66.13},  {115, 9, 66.74},  {145, 12, 109.18}, {148, 13, 84.10},
      {151, 12, 88.11}, {168, 15, 92.93}, {173, 13, 94.30}, {195, 15, 104.21}, {24, 5, {}},
      {44, 6, {}},      {49, 5, {}},      {49, 5, {}},      {49, 6, {}},       {49, 7, {}},
      {53, 6, {}},      {59, 6, {}},      {72, 10, {}},     {92, 7, {}},
  }};
  return panes;
}

Line experiment_large_line() {
  std::vector<vec2> points;
  for (const ExperimentPane& pane : experiment_panes()) points.emplace_back(pane.radial_count, pane.large_count);
  return fitted_line(points);
}

}  // namespace shatterpave::measure
