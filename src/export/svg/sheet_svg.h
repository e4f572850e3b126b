// A sheet to print: all pavements of a scene on one page, to scale.
#pragma once

#include "export/model.h"

namespace shatterpave::exporting::svg {

// Scales are 1 to this.
inline constexpr double largest_scale = 1.0;  // 1:1
inline constexpr double smallest_scale = 10'000.0;

// `SCENE-sheet.svg`: the pavements at 1:`scale` where they lie in the world, seen from above, north up, on the smallest sheet
// of A4 to A0 that holds them; beside them scale bar, north, legend and a table of quantities (paving/quantities/quantities.h).
// One unit of the drawing is one millimetre of paper, so that what is measured on a print at its own size, times `scale`, is
// what is laid. Stones have the classes of drawing_svg.h. Throws InputError, which names a scale that would do, where they do
// not fit A0, and where the scene has no pavement.
OutputFile sheet(const Model& model, double scale);

}  // namespace shatterpave::exporting::svg
