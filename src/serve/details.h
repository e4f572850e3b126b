// What the page shows beside the bodies: numbers and drawings.
#pragma once

#include <string>
#include <vector>

#include "export/model.h"

namespace shatterpave::serve {

struct Details {
  // {"panes": [{name, cracks: {KIND: count}, length_m, pieces, median_piece_mm2, impacts: [{radials, reaching, rings}]}],
  //  "pavements": [{name, area_m2, stones: {"PART KIND": count}, quantities: [{item, count, area_m2, length_m}]}],
  //  "drawings": [names]}; quantities as texts, as the target csv writes them.
  std::string statistics;
  std::vector<exporting::OutputFile> drawings;  // those of the target svg, one a thing
};

Details details(const exporting::Model& model);

}  // namespace shatterpave::serve
