// Drawings as SVG: one file a pane, one a pavement, in millimetres.
#pragma once

#include <vector>

#include "export/target.h"

namespace shatterpave::exporting::svg {

// `SCENE-NAME.svg` for each pane, then for each pavement. A drawing is as large as the thing (width and height in mm), its
// viewBox is in mm with y down, so that scene coordinates are (x, −y). Cracks are polylines of class `crack` and of their kind,
// ids `crack-0` …; stones are polygons of class `stone`, of their part (`field`, `border`, `kerb`,
// `step`) and of their kind, ids `stone-0` ….
std::vector<OutputFile> svg_files(const Model& model);

void append(const Model& model, Outputs& outputs);

inline constexpr Target target{
    .name = "svg", .sentence = "a drawing in millimetres of each pane and pavement (SCENE-NAME.svg)", .append = append};

}  // namespace shatterpave::exporting::svg
