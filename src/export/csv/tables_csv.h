// Quantities as tables that spreadsheets read (CSV, RFC 4180 but for lines that end in LF alone): the stones with what each is
// cut from, what is to be ordered, and the cracks.
#pragma once

#include <vector>

#include "export/target.h"

namespace shatterpave::exporting::csv {

// Three tables, each with a row of names first, also where there is nothing to list:
//   SCENE-stones.csv      a row for each stone: pavement, id, part, kind, length_mm, width_mm, area_mm2, x_mm, y_mm, angle_deg,
//   stock SCENE-quantities.csv  rows of pavement, item, count, area_m2, length_m; what a row does not have is empty
//   SCENE-cracks.csv      a row for each point of each crack: pane, crack, kind, impact, index, x_mm, y_mm
// docs/quantities.md tells users what each item is. Lengths and areas are rounded to 0.001 mm, 0.001 mm², 0.000001 m², 0.001 m.
std::vector<OutputFile> csv_files(const Model& model);

void append(const Model& model, Outputs& outputs);

inline constexpr Target target{
    .name = "csv",
    .sentence =
        "quantities as tables: stones and what they are cut from, stones to order, joints, kerbs; cracks (SCENE-stones.csv, "
        "SCENE-quantities.csv, SCENE-cracks.csv)",
    .append = append};

}  // namespace shatterpave::exporting::csv
