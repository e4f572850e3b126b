// Breaks a pane and writes its geometry, by what is installed alone.
#include <iostream>

#include "export/json/geometry_json.h"
#include "glass/breaking.h"

int main() {
  using namespace shatterpave;
  exporting::Model model;
  model.name = "consumer";
  model.seed = 3;
  glass::Pane pane;
  pane.name = "window";
  pane.outline_mm = {{0.0, 0.0}, {300.0, 0.0}, {300.0, 300.0}, {0.0, 300.0}};
  glass::Impact impact;
  impact.at_mm = {150.0, 150.0};
  impact.radial_count = 24;
  pane.impacts.push_back(impact);
  model.panes.push_back({pane, glass::broken(pane, model.seed)});
  std::cout << exporting::json::json_file(model).content;
}
