// The two walls of a gap before and after they are cut off at its ends: see crack_surface.h.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "core/vec.h"

namespace shatterpave::glass {

// Grids of points, column by column along the crack; point r of column c is number c * rows + r.
struct Walls {
  std::size_t rows = 0;
  std::vector<vec3> left;
  std::vector<vec3> right;
  std::vector<double> along_mm;  // of each column

  std::size_t columns() const { return along_mm.size(); }
  bool operator==(const Walls&) const = default;
};

// What walls end before, at a height z: pieces of lines in the plane, each from first to second.
using Pieces = std::vector<std::pair<vec2, vec2>>;
struct Barrier {
  std::function<Pieces(double z_mm)> pieces;
  bool uneven = false;  // does not run through: between two rows of the walls it may reach farther than at either
};

// The lines that the walls, and the columns at their ends, draw in the plane at height z, of the columns from `from_mm` to
// `to_mm` along. Above and below the walls they are those of their border.
void append_slice(const Walls& walls, double z_mm, double from_mm, double to_mm, Pieces& pieces);

// Cuts the walls off, row by row, where they first meet the barrier among the last `zone_mm`, and `clearance_mm` before; where
// they do not, `clearance_mm` before their end. Before that the walls are led on straight by `zone_mm`, if they are to `reach`.
void cut_end(Walls& walls, const Barrier& barrier, double zone_mm, double clearance_mm, bool reach);

// Cuts row r of the walls off `lags_mm[r]` before their end; columns of twice the longest of these are shared out anew.
void cut_back(Walls& walls, const std::vector<double>& lags_mm);

// The same walls, of a path that is `length_mm` long, from end to start; left and right stay what they were.
void reverse(Walls& walls, double length_mm);

}  // namespace shatterpave::glass
