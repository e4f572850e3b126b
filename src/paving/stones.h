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

// What a stone is of: the bond of a pavement, the course along its border, a kerb (paving/derived/kerb.h), or a step of a
// flight (paving/derived/steps.h).
enum class StonePart { field, border, kerb, step };

struct Stone {
  int id = 0;  // its index among all that were laid; those of missing stones are left out
  StoneKind kind = StoneKind::whole;
  geometry::Polygon outline_mm;  // its face before edges are rounded; counter-clockwise, simple, on the lattice
  Angle angle;                   // of its rows, from +x; of a scale, where its tip points
  StonePart part = StonePart::field;
  double sunk_mm = 0.0;  // how far it lies in a hollow of its own, >= 0
  int colour = -1;       // which of the user's own colours it has; -1: the material's

  bool operator==(const Stone&) const = default;
};

// Stones do not overlap, and lie within the area of their pavement: exactly, on the lattice. Neighbours are a joint apart.
struct StoneLayout {
  std::vector<Stone> stones;
  std::vector<Stone> missing;  // those that would lie in hollows of stones laid by hand, where the filling shows; by id

  bool operator==(const StoneLayout&) const = default;
};

}  // namespace shatterpave::paving
