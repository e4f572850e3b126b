// Corners of the shapes of a module that are meant to be one.
#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "paving/bonds/module_repeats.h"

namespace shatterpave::paving {

// Whether the polygon, rounded to the lattice, is simple, counter-clockwise and without repeated corners.
bool is_sound(const geometry::Polygon& polygon);

// The shapes with corners that are meant to be one made one; a shape that would not bear it stays as it is.
std::vector<geometry::Polygon> welded(const std::vector<geometry::Polygon>& shapes, const Repeats& repeats);

}  // namespace shatterpave::paving
