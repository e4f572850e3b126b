// The sheets of glass that a pane is made of: one, or the two of laminated glass.
#pragma once

#include "glass/pane.h"

namespace shatterpave::glass {

// Which sheet: that which is hit, towards the viewer, or the other one.
enum class Ply { near, far };

// From face to face of a sheet; z is 0 in the middle of the pane and rises towards the viewer.
struct Sheet {
  double thickness_mm = 0.0;
  double middle_mm = 0.0;  // z

  bool operator==(const Sheet&) const = default;
};

// Whether the pane breaks as two sheets with a film between them: laminated glass without shards, whose cracks are its own.
bool has_two_sheets(const Pane& pane);

// The film of windscreens: 0.76 mm, two layers of 0.38 mm (EN ISO 12543-5 has films by those), but at most a quarter of the
// pane.
double film_mm(const Pane& pane);

// The sheet that cracks run through; of panes that are one sheet that one, whatever is asked for.
Sheet sheet_of(const Pane& pane, Ply ply);

}  // namespace shatterpave::glass
