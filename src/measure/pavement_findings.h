// Pavements held against what a good paviour is held to. The targets are this project's own, chosen beside what the best
// field-aligned meshers reach on the same plan (a quarter annulus of radii 4 m and 10 m with 7,000 stones).
#pragma once

#include <span>
#include <vector>

#include "measure/finding.h"
#include "measure/pavement_measures.h"
#include "paving/pavement.h"

namespace shatterpave::measure {

// Of one or more layouts of the pavement, with one seed each. A pavement must be good with any seed: each finding is of the
// seed where it is worst. Cobbles and scales (`Pavement::cell`) are held to what makes a layout sound alone: no overlaps,
// nothing outside, no bare spots, as many as the area takes.
std::vector<Finding> pavement_findings(const paving::Pavement& pavement, std::span<const LayoutFigures> layouts);

}  // namespace shatterpave::measure
