// What paving makes of a pavement: its stones, as outlines in the plane.
#pragma once

#include <vector>

#include "core/angle.h"
#include "geometry/polygon.h"

namespace shatterpave::paving {

enum class StoneKind {
  whole,
  cut,  // the outline or a hole took part of it
};

// What of a pavement a stone is of: the bond, or the course along its border.
enum class StonePart { field, border };

struct Stone {
  int id = 0;  // its index among all that were laid; those of missing stones are left out
  StoneKind kind = StoneKind::whole;
  geometry::Polygon outline_mm;  // its face before edges are rounded; counter-clockwise, simple, on the lattice
  Angle angle;                   // of its rows, from +x
  StonePart part = StonePart::field;

  bool operator==(const Stone&) const = default;
};

// Stones do not overlap, and lie within the area of their pavement: exactly, on the lattice. Neighbours are a joint apart.
struct StoneLayout {
  std::vector<Stone> stones;

  bool operator==(const StoneLayout&) const = default;
};

}  // namespace shatterpave::paving
